"""What the dashboard costs: the first views of a database of 100,000 jobs, a picture of 100,000
particles, and fifty pages that look on while a campaign works. Usage: dashboard.py EERIE [JOBS]. Needs Chromium (tests/e2e/browser)."""

import asyncio
import json
import os
import re
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import urllib.request

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../e2e/browser"))

TICKS_PER_S = os.sysconf("SC_CLK_TCK")


def run(eerie, folder, *arguments):
    subprocess.run([eerie, *arguments], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)


def started(eerie, folder, *arguments):
    """The process and the address of its dashboard."""
    process = subprocess.Popen([eerie, *arguments], cwd=folder, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True)
    for line in process.stdout:
        if found := re.match(r"dashboard: (http://[^/]+)/", line):
            return process, found[1]
    raise SystemExit("the program ended without a dashboard")


def processor_s(pid):
    with open(f"/proc/{pid}/stat") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS_PER_S


def sweep(folder, name, grid, end_time_s):
    with open(f"{folder}/{name}.json", "w") as file:
        json.dump({"name": name, "scene": {"numerics": {"particles_per_target": 100},
                                           "end": {"time_s": end_time_s}}, "grid": grid}, file)
    return f"{name}.json"


def finish_half(database):
    """As in the middle of a campaign: half of the jobs have results, some failed."""
    with sqlite3.connect(database) as sql:
        sql.execute("""INSERT INTO job_results (job_id, class, m_lr_over_m_total, m_slr_over_m_total,
            b_over_a, c_over_a, period_h, eer, n_eer, n_remnants, settled, steps, particle_steps, wall_s,
            threads, solver_version, host)
            SELECT id, 'perfect-merging', 0.97, 0.01, 0.2 + 0.001 * (id % 700), 0.2, 9, id % 700 < 100,
            id % 700 < 100, 1, 1, 1000, 2e6, 3, 1, '0.1.0', 'here' FROM jobs WHERE id % 2 = 0""")
        sql.execute("UPDATE jobs SET state = 'done' WHERE id % 2 = 0")
        sql.execute("UPDATE jobs SET state = 'failed' WHERE id % 101 = 1 AND state = 'pending'")
        sql.execute("""INSERT INTO attempts (job_id, host, pid, version, worker, ended, exit_reason,
            failure_kind, message, core_seconds, particle_steps)
            SELECT id, 'here', 1, '0.1.0', '1', strftime('%Y-%m-%dT%H:%M:%fZ', 'now'),
            iif(state = 'done', 'finished', 'failed'), iif(state = 'done', NULL, 'not-finite'), 'x', 3, 2e6
            FROM jobs WHERE state IN ('done', 'failed')""")


def answer_s(base, path):
    start = time.perf_counter()
    with urllib.request.urlopen(base + path) as answer:
        size = len(answer.read())
    return time.perf_counter() - start, size


def first_views(eerie, folder):
    from browser import Browser
    process, base = started(eerie, folder, "serve", "--port", "0")
    for path in ["/api/campaign", "/api/maps", "/api/map?q=1&phi_d=40&settings=1", "/api/jobs?limit=50",
                 "/api/jobs?limit=50&where=b_over_a%3D0.2:0.3&sort=-b_over_a", "/api/timeline"]:
        before = processor_s(process.pid)
        seconds, size = answer_s(base, path)
        print(f"{path}: {1000 * seconds:.0f} ms, {1000 * (processor_s(process.pid) - before):.0f} ms "
              f"of processor time, {size / 1000:.0f} kB")
    process.terminate()
    process.wait()
    process, base = started(eerie, folder, "serve", "--port", "0")
    with Browser(base) as page:
        page.open("/compare")  # the browser has started and knows the page's files
        for path in ["/campaign", "/map", "/jobs"]:
            page.js("window.from = performance.now(); document.querySelector(`header a[href='${arguments[0]}']`).click()", path)
            page.ready(path)
            spent = page.js("""return Math.max(...performance.getEntriesByType('resource')
                .filter(e => e.name.includes('/api/') && !e.name.includes('events')).map(e => e.responseEnd)) - from""")
            print(f"{path} in the browser: data there after {spent:.0f} ms")
        pictures(page)
    process.terminate()
    process.wait()


def pictures(page, particles=100_000, turns=60):
    """The page's own share of a picture is its script, which every machine has to run; the rest is
    the drawing, here without a GPU."""
    own, whole = page.js("""
        const [n, turns] = arguments;
        return import('/page/points.js').then(({Points}) => {
          const canvas = document.createElement('canvas');
          canvas.style.cssText = 'width: 900px; height: 600px';
          document.body.append(canvas);
          const points = new Points(canvas, new AbortController().signal), gl = points.renderer.getContext();
          points.positions(new Float32Array(3 * n).map(() => 2 * Math.random() - 1), 0.01);
          points.colours(new Uint8Array(4 * n).fill(200));
          points.fit();
          const one = new Uint8Array(4), own = [], whole = [];
          for (let k = 0; k < turns; ++k) {
            const from = performance.now();
            points.rotate(0.02, 0.01);
            points.draw();
            own.push(performance.now() - from);
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, one);  // waits for the drawing
            whole.push(performance.now() - from);
          }
          points.dispose();
          canvas.remove();
          const median = (times) => times.sort((a, b) => a - b)[turns / 2];
          return [median(own), median(whole)];
        });""", particles, turns)
    print(f"a picture of {particles} particles: {own:.2f} ms of the page's own, {whole:.0f} ms with the "
          "drawing by the processor")


async def page_that_looks_on(host, port, until, asked):
    """Reads the events, and asks for the campaign when the database has changed, as the page does."""
    reader, writer = await asyncio.open_connection(host, port)
    writer.write(f"GET /api/events HTTP/1.1\r\nHost: {host}\r\n\r\n".encode())
    while time.time() < until:
        try:
            line = await asyncio.wait_for(reader.readline(), max(0.01, until - time.time()))
        except asyncio.TimeoutError:
            break
        if line.startswith(b"event: database"):
            asked[0] += 1
            other, pen = await asyncio.open_connection(host, port)
            pen.write(f"GET /api/campaign HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n".encode())
            await other.read()
            pen.close()
            await asyncio.sleep(2)
    writer.close()


async def look_on(base, pages, seconds):
    host, port = base.removeprefix("http://").split(":")
    asked, until = [0], time.time() + seconds
    await asyncio.gather(*[page_that_looks_on(host, int(port), until, asked) for _ in range(pages)])
    return asked[0]


def fifty_pages(eerie, folder, pages=50, seconds=60):
    run(eerie, folder, "submit", sweep(folder, "work", {"v_imp_cm_per_s": [15, 20, 25, 30],
                                                        "numerics.seed": list(range(500))}, 3000),
        "--db", "work.sqlite")
    daemon = subprocess.Popen([eerie, "daemon", "--db", "work.sqlite", "--workers", "1", "--min-free-mb", "1"],
                              cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    process, base = started(eerie, folder, "serve", "--db", "work.sqlite", "--port", "0")
    time.sleep(3)
    before, daemon_before = processor_s(process.pid), processor_s(daemon.pid)
    asked = asyncio.run(look_on(base, pages, seconds))
    share = (processor_s(process.pid) - before) / seconds
    with sqlite3.connect(f"{folder}/work.sqlite") as sql:
        done = sql.execute("SELECT count(*) FROM job_results").fetchone()[0]
    print(f"{pages} pages for {seconds} s beside a campaign ({done} jobs done): the server took "
          f"{100 * share:.2f} % of a core for {asked} views, the manager "
          f"{100 * (processor_s(daemon.pid) - daemon_before) / seconds:.2f} %")
    for one in (process, daemon):
        one.send_signal(signal.SIGTERM)
        one.wait()


def main():
    eerie, jobs = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 100_000
    with tempfile.TemporaryDirectory() as folder:
        grid = {"v_imp_cm_per_s": [10 + 1.25 * k for k in range(20)],
                "theta_imp_deg": [5, 10, 15, 20, 25], "numerics.seed": list(range(jobs // 100))}
        run(eerie, folder, "submit", sweep(folder, "large", grid, 30000))
        finish_half(f"{folder}/eerie.sqlite")
        first_views(eerie, folder)
        fifty_pages(eerie, folder)


if __name__ == "__main__":
    main()
