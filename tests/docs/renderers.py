#!/usr/bin/env python3
"""Fails where a browser and librsvg show a committed figure differently. Run it with Debian's python3.

usage: renderers.py ROOT [--all]    (without --all: every kind of figure, not every figure)
Both draw each SVG 600 pixels wide, with the fonts of DejaVu. Edges and letters are smoothed differently,
so what is compared are means over squares of 24 pixels (14 letters): of all figures that are the same
to the eye the worst differs by 0.03 of the way from black to white in one square. Words that one of
the two leaves out, or puts elsewhere, make 0.1 and more.
"""
import base64
import io
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy
from matplotlib.image import imread
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

WIDTH, SQUARE, HIGHEST_PAGE = 600, 24, 4000
MOST_IN_SQUARE, MOST_ON_AVERAGE = 0.06, 0.03
KINDS = ("docs/gallery/*.svg", "docs/explanation/drawings/*.svg", "docs/notebook/scale/*.svg",
         "docs/notebook/accuracy/settled.svg", "docs/notebook/figures/*/s*.svg")


def height_of(svg):
    box = re.search(r'viewBox="([^"]+)"', svg.read_text(encoding="utf8"))
    assert box, f"{svg}: has no viewBox, so that pages cannot scale it"
    _, _, wide, high = map(float, box[1].split())
    return round(WIDTH * high / wide)


def grey(png):
    return imread(io.BytesIO(png))[..., :3].mean(axis=2)


def by_librsvg(svg):
    done = subprocess.run(["rsvg-convert", "-w", str(WIDTH), "-h", str(height_of(svg)), "-b", "white", str(svg)],
                          capture_output=True)
    assert done.returncode == 0, f"{svg}: rsvg-convert: {done.stderr.decode()}"
    return grey(done.stdout)


class Browser:
    """A headless Chromium; images of a page, as readers of Markdown show them."""

    def __init__(self, folder):
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for argument in ("--headless=new", "--no-sandbox", "--hide-scrollbars", "--disable-lcd-text"):
            options.add_argument(argument)
        self.page = pathlib.Path(folder) / "page.html"
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)

    def __enter__(self):
        return self

    def __exit__(self, *problem):
        self.driver.quit()

    def draw(self, svgs):
        """Their pictures; one long page and one shot for all."""
        images = "".join(f'<img style="display:block; width:{WIDTH}px; height:{height_of(svg)}px" '
                         f'src="{svg.resolve().as_uri()}">' for svg in svgs)
        self.page.write_text(f'<body style="margin:0; background:white">{images}')
        heights = [height_of(svg) for svg in svgs]
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": WIDTH, "height": sum(heights), "deviceScaleFactor": 1, "mobile": False})
        self.driver.get(self.page.as_uri())
        shot = grey(base64.b64decode(
            self.driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "png"})["data"]))
        return numpy.split(shot, numpy.cumsum(heights)[:-1])


def batches(svgs):
    """Pages that a browser can still show in one piece."""
    batch, high = [], 0
    for svg in svgs:
        if batch and high + height_of(svg) > HIGHEST_PAGE:
            yield batch
            batch, high = [], 0
        batch.append(svg)
        high += height_of(svg)
    if batch:
        yield batch


def squares(picture):
    high, wide = (n // SQUARE for n in picture.shape)
    return picture[:high * SQUARE, :wide * SQUARE].reshape(high, SQUARE, wide, SQUARE).mean(axis=(1, 3))


def differences(svgs, browser):
    """Of each: on average, and in the worst square."""
    for batch in batches(svgs):
        for svg, b in zip(batch, browser.draw(batch)):
            a = by_librsvg(svg)
            assert a.shape == b.shape, f"{svg}: {a.shape} pixels by librsvg, {b.shape} in a browser"
            assert a.std() > 0.01, f"{svg}: is blank"
            yield svg, numpy.abs(a - b).mean(), numpy.abs(squares(a) - squares(b)).max()


def is_bad(of_all, of_square):
    return of_all > MOST_ON_AVERAGE or of_square > MOST_IN_SQUARE


def broken_copy(svg, folder):
    """With words that browsers alone show: HTML within SVG."""
    copy = pathlib.Path(folder) / "broken.svg"
    words = ('<foreignObject x="80" y="100" width="90" height="20"><p xmlns="http://www.w3.org/1999/xhtml" '
             'style="font: 8px DejaVu Sans; margin: 0">seen by some</p></foreignObject>')
    copy.write_text(svg.read_text(encoding="utf8").replace("</svg>", words + "</svg>"), encoding="utf8")
    return copy


def main(root, every):
    svgs = sorted({f for kind in (["docs/**/*.svg"] if every else KINDS) for f in root.glob(kind)})
    assert len(svgs) > 20, f"{root} holds no figures"
    bad, noticed = [], False
    with tempfile.TemporaryDirectory() as folder, Browser(folder) as browser:
        broken = broken_copy(root / "docs/gallery/sizes.svg", folder)
        for svg, of_all, of_square in differences([broken, *svgs], browser):
            if svg == broken:
                noticed = is_bad(of_all, of_square)
            elif is_bad(of_all, of_square):
                bad.append(f"{svg.relative_to(root)}: a browser and librsvg differ by {of_square:.2f} in a square, "
                           f"by {of_all:.3f} on average (at most {MOST_IN_SQUARE}, {MOST_ON_AVERAGE})")
            elif every:
                print(f"{of_square:.3f} {of_all:.3f} {svg.relative_to(root)}")
    assert noticed, "words that only one of the two shows are not noticed"
    print("\n".join(bad) if bad else f"{len(svgs)} figures, alike in a browser and in librsvg")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), "--all" in sys.argv))
