"""Every view of a finished campaign: what it shows, its address, its keys, both widths."""

import sys
import time
import urllib.request

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin

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


def ticks(page, picture):
    """The texts of a picture's axes; all of them lie within it, and none on another of its axis."""
    axes = page.js("""
        const box = (n) => n.getBoundingClientRect(), picture = document.querySelector(arguments[0]), all = box(picture);
        return [...picture.querySelectorAll('.axis-lines')].map(axis => {
          const texts = [...axis.querySelectorAll('.tick text')], at = texts.map(box);
          return {texts: texts.map(t => t.textContent),
                  out: texts.filter((t, k) => at[k].left < all.left - 1 || at[k].right > all.right + 1
                                           || at[k].top < all.top - 1 || at[k].bottom > all.bottom + 1).map(t => t.textContent),
                  on_another: at.some((a, k) => at.some((b, j) => j < k && a.left < b.right && b.left < a.right
                                                                       && a.top < b.bottom - 3 && b.top < a.bottom - 3))};
        })""", picture)
    expect(axes, f"{picture} has axes")
    for axis in axes:
        expect(axis["texts"] and not axis["out"] and not axis["on_another"], f"{picture}: {axis}")
    return [axis["texts"] for axis in axes]


def at_both_widths(page, path, picture, of):
    for width in (390, 1280):
        page.size(width, 844)
        page.open(path)
        page.until(lambda: page.all(f"{picture} .tick"), f"{picture} has ticks")
        of(ticks(page, picture))
    page.size(1280, 900)


def campaign(page):
    page.open("/campaign")
    expect("100 %" in page.text() and "4 of 4 jobs" in page.text(), page.text())
    expect("shapes" in page.text("table"), "the sweep is named")
    page.until(lambda: page.all(".timeline .span"), "workers have bars")
    at_both_widths(page, "/campaign", ".timeline svg", lambda axes: expect(":" in axes[0][0], f"times of day: {axes}"))
    fits(page, "/campaign")


def the_map(page):
    page.open("/map?quantity=class")
    expect(len(page.all("[data-cell]")) == 4, "a cell for each impact")
    expect(page.all("svg .paper"), "the paper's curve is drawn")
    expect("quantity=class" in page.driver.current_url, "the address keeps the quantity")
    at_both_widths(page, "/map", ".map-svg", lambda axes: expect(
        axes[:2] == [["15", "20"], ["10", "15"]] and len(axes[2]) > 1, f"speeds, angles, speeds over that of escape: {axes}"))
    at_both_widths(page, "/map", ".legend .scale", lambda axes: expect("0.3" in axes[0], f"the limit of EERs: {axes}"))
    page.open("/map?quantity=class")
    expect(any(name in page.text(".legend") for name in ("merging", "hit-and-run", "erosion", "disruption",
                                                         "accretion", "graze")), page.text(".legend"))
    page.keys("[data-cell][tabindex='0']", "\ue014")  # the right arrow
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
    page.keys("input[name='v']", "20\n")
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


def turning(page):
    """Mouse, wheel, keys and fingers change the picture; without them it is not drawn again."""
    canvas = page.one("canvas")
    page.js("arguments[0].style.outline = 'none'", canvas)  # what is focused is not what has turned
    shot = lambda: canvas.screenshot_as_png
    drag = lambda: ActionChains(page.driver).move_to_element(canvas).click_and_hold().move_by_offset(60, 20).move_by_offset(30, 10).release().perform()
    wheel = lambda: ActionChains(page.driver).scroll_from_origin(ScrollOrigin.from_element(canvas), 0, -240).perform()
    before = shot()
    for what, deed in [("a drag", drag), ("the wheel", wheel), *[(key, lambda key=key: canvas.send_keys(key)) for key in "\ue012\ue013+-"]]:
        deed()
        page.until(lambda: shot() != before, f"{what} changes the picture")
        before = shot()
    zoom = lambda: page.js("return document.querySelector('.viewer').points.camera.zoom")
    before, centre = zoom(), page.js("const b = arguments[0].getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]", canvas)
    for kind, apart in [("touchStart", 20), ("touchMove", 40), ("touchMove", 60), ("touchEnd", 0)]:
        page.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [
            {"x": centre[0] + side * apart, "y": centre[1], "id": side + 1} for side in (-1, 1) if apart]})
    page.until(lambda: zoom() > 2 * before, "fingers that part zoom in")
    page.until(lambda: not page.js("return document.querySelector('.viewer').points.waiting"), "all is drawn")
    frames = page.js("return document.querySelector('canvas').dataset.frames")
    time.sleep(0.3)
    expect(page.js("return document.querySelector('canvas').dataset.frames") == frames, "it is drawn when something changes")


def job(page, name):
    page.open(f"/job/{name}")
    page.until(lambda: page.js("return document.querySelector('canvas').dataset.shown") is not None, "particles are drawn")
    turning(page)
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
    page.click(".play")
    page.until(lambda: page.js("return document.querySelector('canvas').dataset.shown") == str(last), "it plays to the last")
    expect("b/a" in page.text(".caption"), "the axes of the remnant are told")
    page.until(lambda: len(page.all(".chart svg[role='img']")) == 4, "four charts over time")
    at_both_widths(page, f"/job/{name}", ".chart svg[role='img']", lambda axes: expect(
        axes[0] == ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"] and len(axes[1]) > 1, f"b/a over time: {axes}"))
    text = page.text()
    for word in ("numerics.particles_per_target", "instead of", "finished", "compiler", "Remnants"):
        expect(word in text, f"{word} is on the page")
    page.until(lambda: "done:" in page.text(".log"), "the log is there")
    fits(page, f"/job/{name}")


def compare(page):
    page.open("/jobs")
    for box in page.all("table.jobs tbody input")[:2]:
        box.click()
    page.click("a.button[href^='/compare']")
    page.until(lambda: len(page.all(".side-by-side canvas")) == 2, "two jobs side by side")
    expect("impact.theta_imp_deg" in page.text("table.compare"), "what differs in the scene")
    fits(page, page.driver.current_url[len(base):])


def many_pages(page):
    """A browser has six connections to a server: pages that it keeps for the way back hold none."""
    for _ in range(8):
        page.open("/jobs")
    waited = page.js("const [n] = performance.getEntriesByType('navigation'); return n.requestStart - n.fetchStart")
    expect(waited < 5000, f"the eighth page waited {waited} ms for a connection")


with Browser(base) as page:
    campaign(page)
    the_map(page)
    hash_of_one = jobs(page)
    job(page, hash_of_one)
    compare(page)
    many_pages(page)
    expect(not page.all("[data-action]"), "without the token there are no buttons")
    complaints = page.complaints()
    expect(complaints == [c for c in complaints if "400" in c], f"the browser complains: {complaints}")
print("every view was shown")
