"""A campaign at work: cells fill in, a job is paused and resumed with the token, and not without."""

import json
import sys
import urllib.error
import urllib.request

from browser import Browser, expect

base, token = sys.argv[1], sys.argv[2]


def jobs():
    with urllib.request.urlopen(base + "/api/campaign") as answer:
        return json.load(answer)["jobs"]


def status_of(headers):
    request = urllib.request.Request(base + "/api/requests", data=b'{"kind": "pause", "all": true}',
                                     headers={"Content-Type": "application/json", **headers})
    try:
        return urllib.request.urlopen(request).status
    except urllib.error.HTTPError as refusal:
        return refusal.code


expect(status_of({}) == 403, "no origin and no token")
expect(status_of({"Origin": base}) == 403, "no token")
expect(status_of({"Origin": base, "X-Eerie-Token": "0" * 32}) == 403, "a wrong token")
expect(status_of({"Origin": "http://evil.example", "X-Eerie-Token": token}) == 403, "another page")
expect(jobs()["paused"] == 0, "nothing was paused")

with Browser(base, token) as page:
    page.open("/map")
    filled = lambda: len(page.all("[data-cell] .value"))
    page.until(lambda: page.all("[data-state='running']"), "a cell is at work")
    before = filled()
    page.until(lambda: filled() > before, "a cell fills in while one looks", 120)
    page.until(lambda: page.text("#pulse") == "live", "the page says that somebody works")

    page.open("/jobs?state=pending")
    link = page.all("table.jobs a.hash")[-1].get_attribute("href")  # the last one to run
    page.open(link[len(base):])
    page.press("[data-action='pause']", lambda: "1 job paused" in page.text("#toast"),
               "the answer of the manager")
    page.until(lambda: "paused" in page.text(".job-head .badge"), "the page shows it by itself")
    expect(jobs()["paused"] == 1, f"one job is paused: {jobs()}")
    page.press("[data-action='resume']", lambda: "1 job resumed" in page.text("#toast"), "resumed")
    page.until(lambda: "paused" not in page.text(".job-head .badge"), "the page shows that too")
    expect(jobs()["paused"] == 0, "none is paused")

    page.open("/campaign")
    page.press(".submit summary", lambda: page.js("return document.querySelector('.submit').open"),
               "the form opens", again_after=2)
    page.keys(".submit textarea", '{"name": "more", "scene": {"numerics": {"particles_per_target": 100}}, "grid": {"v_imp_cm_per_s": [33]}}')
    page.press("[data-action='submit']", lambda: "more: 1 jobs, 1 new" in page.text("#toast"),
               "the sweep is taken")
    page.until(lambda: "more" in page.text("table"), "and stands in the table")
    expect(not page.complaints(), f"the browser complains: {page.complaints()}")
print("a campaign was watched and steered")
