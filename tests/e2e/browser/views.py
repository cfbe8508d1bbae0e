"""Every view of a finished campaign: what it shows, its address, its keys, both widths."""

import sys
import urllib.request

from browser import Browser, expect

base = sys.argv[1]


def read(path):
    with urllib.request.urlopen(base + path) as answer:
        return answer.read().decode()


def fits(page, path):
    """Nothing reaches beyond the page at either width, light or dark."""
    for width, dark in [(1280, False), (390, True)]:
        page.size(width, 844, dark)
        page.open(path)
        excess = page.js("return document.documentElement.scrollWidth - innerWidth")
        expect(excess <= 0, f"{path} is {excess} pixels too wide at {width}")
    page.size(1280, 900)


def campaign(page):
    page.open("/campaign")
    expect("100 %" in page.text() and "4 of 4 jobs" in page.text(), page.text())
    expect("shapes" in page.text("table"), "the sweep is named")
    page.until(lambda: page.all(".timeline .span"), "workers have bars")
    fits(page, "/campaign")


def the_map(page):
    page.open("/map?quantity=class")
    expect(len(page.all("[data-cell]")) == 4, "a cell for each impact")
    expect(page.all("svg .paper"), "the paper's curve is drawn")
    expect("quantity=class" in page.driver.current_url, "the address keeps the quantity")
    expect(any(name in page.text(".legend") for name in ("merging", "hit-and-run", "erosion", "disruption",
                                                         "accretion", "graze")), page.text(".legend"))
    page.one("[data-cell][tabindex='0']").send_keys("\ue014")  # the right arrow
    expect(page.js("return document.activeElement.dataset.cell").startswith("20,"), "keys move")
    page.until(lambda: "b/a" in page.text(".hover"), "numbers of the cell are shown")
    page.js("document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter', bubbles: true}))")
    page.until(lambda: "/job/" in page.driver.current_url, "a cell with one job leads to it")
    page.driver.back()
    page.until(lambda: page.driver.current_url.split("?")[0].endswith("/map"), "back leads back")
    page.until(lambda: page.all("[data-cell].selected"), "and the cell is marked")
    fits(page, "/map")


def jobs(page):
    page.open("/jobs?sort=-b_over_a")
    column = page.js("return [...document.querySelectorAll('table.jobs thead th')].findIndex(h => h.textContent.startsWith('b/a'))")
    shown = [float(row) for row in page.js(
        "return [...document.querySelectorAll('table.jobs tbody tr')].map(r => r.children[arguments[0]].textContent)", column)]
    expect(len(shown) == 4 and shown == sorted(shown, reverse=True), f"sorted: {shown}")
    field = page.one("input[name='v']")
    field.send_keys("20\n")
    page.until(lambda: len(page.all("table.jobs tbody tr")) == 2, "the filter leaves two")
    expect("v=20" in page.driver.current_url, "the address keeps the filter")
    link = page.one("a[download]").get_attribute("href")
    rows = read(link[len(base):]).strip().split("\n")
    expect(len(rows) == 3 and rows[0].startswith("hash,"), f"what is seen is exported: {rows}")
    page.open("/jobs?where=nonsense%3D1")
    expect("the closest are" in page.text(), "a wrong filter is told")
    fits(page, "/jobs")
    page.open("/jobs")
    return page.one("table.jobs a.hash").get_attribute("href").split("/")[-1]


def job(page, name):
    page.open(f"/job/{name}")
    page.until(lambda: page.js("return document.querySelector('canvas').dataset.shown") is not None, "particles are drawn")
    colours = page.js("""
        const canvas = document.querySelector('canvas'), copy = document.createElement('canvas');
        copy.width = copy.height = 200;
        return new Promise(done => requestAnimationFrame(() => {
          canvas.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft'}));
          requestAnimationFrame(() => {
            const pen = copy.getContext('2d');
            pen.drawImage(canvas, 0, 0, 200, 200);
            const d = pen.getImageData(0, 0, 200, 200).data, seen = new Set();
            for (let i = 0; i < d.length; i += 4) seen.add(`${d[i] >> 5},${d[i + 1] >> 5},${d[i + 2] >> 5}`);
            done(seen.size);
          });
        }));""")
    expect(colours > 5, f"shaded balls of two colours on a plain ground: {colours}")
    for choice in ("depth", "speed", "pressure", "remnant"):
        page.js("const s = document.querySelector('.viewer select'); s.value = arguments[0]; s.dispatchEvent(new Event('change'))", choice)
        page.until(lambda: page.text(".viewer .keys"), f"the key of {choice}")
    last = int(page.js("return document.querySelector('.viewer input[type=range]').max"))
    page.js("const s = document.querySelector('.viewer input[type=range]'); s.value = 0; s.dispatchEvent(new Event('input'))")
    page.until(lambda: page.js("return document.querySelector('canvas').dataset.shown") == "0", "the first snapshot")
    page.one(".play").click()
    page.until(lambda: page.js("return document.querySelector('canvas').dataset.shown") == str(last), "it plays to the last")
    expect("b/a" in page.text(".caption"), "the axes of the remnant are told")
    page.until(lambda: len(page.all(".chart svg[role='img']")) == 4, "four charts over time")
    text = page.text()
    for word in ("numerics.particles_per_target", "instead of", "finished", "compiler", "Remnants"):
        expect(word in text, f"{word} is on the page")
    page.until(lambda: "done:" in page.text(".log"), "the log is there")
    fits(page, f"/job/{name}")


def compare(page):
    page.open("/jobs")
    for box in page.all("table.jobs tbody input")[:2]:
        box.click()
    page.one("a.button[href^='/compare']").click()
    page.until(lambda: len(page.all(".side-by-side canvas")) == 2, "two jobs side by side")
    expect("impact.theta_imp_deg" in page.text("table.compare"), "what differs in the scene")
    fits(page, page.driver.current_url[len(base):])


with Browser(base) as page:
    campaign(page)
    the_map(page)
    hash_of_one = jobs(page)
    job(page, hash_of_one)
    compare(page)
    expect(not page.all("[data-action]"), "without the token there are no buttons")
    complaints = page.complaints()
    expect(complaints == [c for c in complaints if "400" in c], f"the browser complains: {complaints}")
print("every view was shown")
