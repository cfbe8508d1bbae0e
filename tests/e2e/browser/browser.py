"""A headless Chromium on a dashboard, and what tests ask of it."""

import json
import time

from selenium import webdriver
from selenium.common.exceptions import (ElementClickInterceptedException, ElementNotInteractableException,
                                        StaleElementReferenceException, WebDriverException)
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

PATIENCE_S = 60


def started(options, attempts=3):
    """A Chromium with its driver. Selenium gives the driver a port that was free a moment ago: another
    program that starts may have taken it, and a busy machine may be late with the browser itself."""
    for attempt in range(1, attempts + 1):
        try:
            return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        except WebDriverException as problem:
            if attempt == attempts:
                raise
            print(f"the browser did not start: {problem.msg}; once more")


class Browser:
    def __init__(self, base, token=""):
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for argument in ["--headless=new", "--no-sandbox", "--hide-scrollbars",
                         "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]:
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = started(options)
        self.base = base
        self.size(1280, 900)
        if token:
            self.driver.get(f"{base}/#token={token}")
            self.until(lambda: "token" not in self.driver.current_url, "the token leaves the address")

    def __enter__(self):
        return self

    def __exit__(self, *problem):
        self.driver.quit()

    def size(self, width, height, dark=False):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})

    def open(self, path):
        self.driver.get(self.base + path)
        self.ready(path)

    def ready(self, path):
        wanted = path.split("?")[0]
        self.until(lambda: self.js("return document.getElementById('view').dataset.ready") == wanted,
                   f"{path} is shown")

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        self.until(lambda: self.all(selector), f"there is {selector}")
        return self.all(selector)[0]

    def on(self, selector, deed):
        """What `deed` gives for an element: the one that is there, where a page that draws itself anew
        has replaced it meanwhile."""
        done = []

        def tried():
            done.append(deed(self.one(selector)))
            return True
        self.until(tried, f"{selector} stays")
        return done[-1]

    def text(self, selector="main"):
        return self.on(selector, lambda node: node.text)

    def click(self, selector):
        self.on(selector, lambda node: node.click())

    def keys(self, selector, text):
        self.on(selector, lambda node: node.send_keys(text))

    def until(self, condition, what, patience=PATIENCE_S):
        end = time.time() + patience
        while time.time() < end:
            try:
                if condition():
                    return
            except (StaleElementReferenceException, ElementNotInteractableException):
                pass  # the page has drawn itself anew meanwhile
            time.sleep(0.05)
        raise AssertionError(f"not within {patience} s: {what}\n{self.said()}")

    def press(self, selector, effect, what, again_after=10):
        """Clicks. A page at work moves and replaces what one aims at: without effect, once more."""
        pressed = 0

        def done():
            nonlocal pressed
            if time.time() - pressed > again_after:
                try:
                    self.one(selector).click()
                    pressed = time.time()
                except ElementClickInterceptedException:
                    return False
            return effect()
        self.until(done, what)

    def said(self):
        return json.dumps(self.driver.get_log("browser"), indent=1)

    def complaints(self):
        """What the page's scripts and the content security policy complained of."""
        return [entry["message"] for entry in self.driver.get_log("browser")
                if entry["level"] == "SEVERE" and "/api/events" not in entry["message"]]


def expect(condition, what):
    if not condition:
        raise AssertionError(what)
