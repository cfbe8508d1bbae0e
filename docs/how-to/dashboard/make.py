#!/usr/bin/env python3
"""Takes the pictures of dashboard.md in a headless Chromium.

With --all every view is taken at both widths, light and dark.
"""
import argparse
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "tests/e2e/browser"))
from browser import Browser  # noqa: E402

WIDE, SMALL = (1280, 900), (390, 844)


def started(program, database):
    server = subprocess.Popen([program, "serve", "--db", database, "--port", "0", "--read-only"],
                              stdout=subprocess.PIPE, text=True)
    for line in server.stdout:
        if found := re.match(r"dashboard: (http://[^/]+)", line):
            return server, found[1]
    sys.exit("the program ended without a dashboard")


def views(page):
    """The addresses of all views; of jobs the three of smallest b/a."""
    page.open("/jobs?state=done&sort=b_over_a")
    links = [a.get_attribute("href")[len(page.base):] for a in page.all("table.jobs a.hash")[:3]]
    hashes = [link.rsplit("/", 1)[1] for link in links]
    return {"campaign": "/campaign", "map": "/map", "jobs": "/jobs?sort=b_over_a", "job": links[0],
            "compare": "/compare?jobs=" + ",".join(hashes)}


def take(page, address, path, size, dark):
    page.size(*size, dark=dark)
    page.open(address)
    if address.startswith(("/job/", "/compare")):
        page.until(lambda: page.all("canvas") and not page.js(
            "return [...document.querySelectorAll('canvas')].some(c => !(c.dataset.frames > 1))"),
            "the particles are there")
    page.driver.save_screenshot(str(path))


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("database")
    arguments.add_argument("program", nargs="?", default=str(ROOT / "build/eerie"))
    arguments.add_argument("-o", "--output", type=pathlib.Path, default=HERE)
    arguments.add_argument("--all", action="store_true")
    a = arguments.parse_args()
    server, base = started(a.program, a.database)
    try:
        with Browser(base) as page:
            for name, address in views(page).items():
                for size, dark, mark in [(WIDE, False, ""), (SMALL, True, "-small-dark"),
                                         (WIDE, True, "-dark"), (SMALL, False, "-small")]:
                    if a.all or mark in ("", "-small-dark"):
                        take(page, address, a.output / f"{name}{mark}.png", size, dark)
            for complaint in page.complaints():
                print(complaint)
    finally:
        server.terminate()
        server.wait()


main()
