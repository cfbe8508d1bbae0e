// Two to four jobs, or cells of maps, side by side.

import { get } from "./api.js";
import { el, fill } from "./dom.js";
import { line_chart } from "./chart.js";
import { digits, fixed, none, short, whole } from "./format.js";
import { cell_facts } from "./map.js";
import { numbers_of, viewer_or_reason } from "./job.js";

const most = 4;

function differing(leaves) {
  const paths = leaves[0].map((l) => l.path);
  const by_path = leaves.map((list) => new Map(list.map((l) => [l.path, JSON.stringify(l.value)])));
  for (const list of leaves) for (const l of list) if (!paths.includes(l.path)) paths.push(l.path);
  return paths.map((path) => [path, by_path.map((m) => m.get(path) ?? none)]).filter(([, values]) => new Set(values).size > 1);
}

const link = (hash) => el("a", { class: "hash", href: `/job/${hash}` }, short(hash));

function table(heads, groups) {
  return el("div", { class: "scroll" }, el("table", { class: "compare" }, el("thead", {}, el("tr", {}, el("th", {}), heads.map((h) => el("th", { scope: "col" }, h)))),
    groups.map(([title, rows]) => rows.length > 0 && el("tbody", {}, el("tr", { class: "group" }, el("th", { colspan: heads.length + 1 }, title)),
      rows.map(([name, values]) => el("tr", {}, el("th", { scope: "row" }, name), values.map((v) => el("td", {}, v))))))));
}

async function compare_jobs(root, hashes, signal) {
  const drawing = viewer_or_reason();
  const jobs = await Promise.all(hashes.map((h) => get(`job/${h}`, {}, signal)));
  const histories = await Promise.all(jobs.map((j) => get(`job/${j.hash}/history`, {}, signal)));
  const viewer = await drawing;
  if (signal.aborted) return;
  const numbers = jobs.map(numbers_of);
  const rows = numbers[0].map(([name], k) => [name, numbers.map((n) => n[k][1])]);
  const lines = (column) => histories.map((h, k) => ({ name: short(jobs[k].hash), x: h.columns.time_s ?? [], y: h.columns[column] ?? [], kind: k + 1 })).filter((l) => l.x.length > 1);
  const charts = [["b_over_a", "b/a of the largest remnant"], ["m_1_over_m_total", "mass of the largest remnant over all mass"]]
    .map(([column, title]) => lines(column).length > 0 && line_chart(lines(column), { title, low: 0, high: 1, marks: column === "b_over_a" ? [{ y: 0.3 }] : [] }));
  fill(root, el("h1", {}, "Compare"), el("section", { class: "card" }, el("div", { class: "side-by-side" }, jobs.map((j) => el("div", {}, el("h3", {}, link(j.hash)), viewer(j.hash, j.snapshots, signal, { small: true }))))),
    el("section", { class: "card" }, table(jobs.map((j) => link(j.hash)), [["outcome", [["state", jobs.map((j) => j.state)], ...rows]], ["what differs in the scene", differing(jobs.map((j) => j.leaves))]])),
    el("section", { class: "card" }, charts));
}

async function compare_cells(root, names, signal) {
  const cells = await Promise.all(names.map(async (name) => {
    const [q, phi_d, v, theta, settings] = name.split("_").map(Number);
    const map = await get("map", { q, phi_d, settings }, signal);
    const cell = map.cells.find((c) => c.v === v && c.theta === theta);
    const { jobs } = await get("cell", { q, phi_d, settings, v, theta }, signal);
    return { map, cell, jobs };
  }));
  const there = cells.filter((c) => c.cell);
  if (there.length === 0) return void fill(root, el("h1", {}, "Compare"), el("p", { class: "empty" }, "No map has such a cell."));
  const labels = ["speed", "angle", "outcome", "b/a", "c/a", "M_lr/M", "period", "EERs", "seeds", "unsettled", "stale"];
  const facts = there.map((c) => new Map(cell_facts(c.cell)));
  const seeds = (c) => el("ul", { class: "plain" }, c.jobs.slice(0, 8).map((j) => el("li", {}, `seed ${j.seed} `, link(j.hash), j.b_over_a === null ? ` ${j.state}` : ` ${fixed(j.b_over_a, 3)} ${j.class}`)));
  fill(root, el("h1", {}, "Compare"), el("section", { class: "card" }, table(there.map((c) => `${c.map.fidelity || `settings ${c.map.settings}`}, ${whole(c.map.particles_per_target)}`), [
    ["bodies", [["q", there.map((c) => digits(c.map.q))], ["φ_d", there.map((c) => `${digits(c.map.phi_d_deg)}°`)]]],
    ["over seeds", labels.filter((l) => facts.some((f) => f.has(l))).map((l) => [l, facts.map((f) => f.get(l) ?? none)])],
    ["jobs", [["", there.map(seeds)]]]])));
}

export async function show_compare(root, { signal, query, go }) {
  const list = (name) => (query.get(name) ?? "").split(",").map((w) => w.trim()).filter(Boolean).slice(0, most);
  if (list("jobs").length > 0) return compare_jobs(root, list("jobs"), signal);
  if (list("cells").length > 0) return compare_cells(root, list("cells"), signal);
  const input = el("input", { "aria-label": "Jobs", placeholder: "3f9a20c1, 84f161d5", class: "grow" });
  const open = (event) => { event.preventDefault(); go(`/compare?jobs=${input.value.split(/[\s,]+/).filter(Boolean).join(",")}`); };
  fill(root, el("h1", {}, "Compare"), el("section", { class: "card" },
    el("p", {}, "Two to four jobs side by side: choose them in the table of ", el("a", { href: "/jobs" }, "jobs"), ", choose a cell of the ", el("a", { href: "/map" }, "map"), ", or name them by the first digits of their hashes."),
    el("form", { class: "row", onsubmit: open }, input, el("button", { class: "main" }, "Compare"))));
}
