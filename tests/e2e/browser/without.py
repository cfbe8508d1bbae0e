"""A page that lacks something: what draws particles, room to listen, the database itself."""

import os
import socket
import sys

from browser import Browser, expect

base, database = sys.argv[1], sys.argv[2]
host, port = base.removeprefix("http://").split(":")
blocked = {"urls": ["*/three.module.js"]}

with Browser(base) as page:
    page.open("/jobs")
    job = page.one("table.jobs a.hash").get_attribute("href")[len(base):]
    page.driver.execute_cdp_cmd("Network.enable", {})
    page.driver.execute_cdp_cmd("Network.setCacheDisabled", {"cacheDisabled": True})
    page.driver.execute_cdp_cmd("Network.setBlockedURLs", blocked)
    page.open(job)
    page.until(lambda: "Particles cannot be drawn" in page.text(".picture-card"), "the picture says why there is none")
    for title in ["Scene", "Attempts", "Log"]:
        expect(title in page.text(), f"the job is shown beside: {page.text()}")
    page.open(f"/compare?jobs={job.split('/')[-1]}")
    expect("what differs" in page.text().lower() or "outcome" in page.text().lower(), page.text())
    expect("Particles cannot be drawn" in page.text(), "each picture says why there is none")

    listening = []
    for _ in range(80):
        listening.append(socket.create_connection((host, int(port))))
        listening[-1].sendall(f"GET /api/events HTTP/1.1\r\nHost: {host}\r\n\r\n".encode())
    page.open("/jobs")
    page.until(lambda: page.text("#pulse") == "at rest", "a page without room to listen asks")
    os.rename(database, database + ".away")
    page.until(lambda: "there is no such file" in page.text("#banner"), "it says that the database is gone")
    for one in listening:
        one.close()
    page.driver.get(base + "/map")
    page.until(lambda: "there is no such file" in page.text("main"), "a view says so, too")
    os.rename(database + ".away", database)
    page.until(lambda: page.all("[data-cell]"), "the view is there with the database")
    page.until(lambda: not page.one("#banner").is_displayed(), "and nothing is wrong any more")
