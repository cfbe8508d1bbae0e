// A table over all jobs, a page at a time: filtered, sorted and counted by the server.

import { get, query_of } from "./api.js";
import { action_bar, may_act } from "./actions.js";
import { el, fill, select } from "./dom.js";
import { gently, listen } from "./events.js";
import { cell, whole } from "./format.js";

const page_size = 50;
const heads = {
  hash: "job", v_imp_cm_per_s: "v, cm/s", theta_imp_deg: "θ, deg", phi_d_deg: "φ_d, deg", particles_per_target: "particles",
  b_over_a: "b/a", m_lr_over_m_total: "M_lr/M", period_h: "period, h", n_eer: "EERs", wall_s: "wall time", end_time_s: "end, s",
};
const job_states = ["pending", "running", "done", "failed", "cancelled"];
const classes = ["perfect-merging", "graze-and-merge", "partial-accretion", "hit-and-run", "erosion", "catastrophic-disruption"];

const filters = ["state", "sweep", "fidelity", "class", "q", "phi_d", "v", "theta", "eer", "settings", "where"];

function parameters_of(query) {
  const found = Object.fromEntries(filters.map((name) => [name, query.get(name) ?? ""]));
  found.where = query.getAll("where");
  return { ...found, sort: query.get("sort") ?? "", offset: Number(query.get("offset") ?? 0) };
}

function filter_form(p, sweeps, change) {
  const text = (name, label, hint) => el("label", { class: "field" }, el("span", {}, label),
    el("input", { name, value: p[name] ?? "", placeholder: hint, onchange: (e) => change({ [name]: e.target.value.trim() }) }));
  const any = (list) => [["", "any"], ...list.map((one) => [one, one])];
  return el("form", { class: "filters", onsubmit: (e) => e.preventDefault(), "aria-label": "Filter" },
    select("state", any(job_states), p.state, (v) => change({ state: v })),
    select("sweep", any(sweeps), p.sweep, (v) => change({ sweep: v })),
    select("fidelity", any(["sketch", "survey", "paper"]), p.fidelity, (v) => change({ fidelity: v })),
    select("class", any(classes), p.class, (v) => change({ class: v })),
    text("q", "q", "1"), text("phi_d", "φ_d, deg", "40"), text("v", "v, cm/s", "18:22"), text("theta", "θ, deg", "10:15"),
    el("label", { class: "field grow" }, el("span", {}, "where"), el("input", { name: "where", value: p.where.join("; "), placeholder: "b_over_a=0:0.3; seed=1",
      onchange: (e) => change({ where: e.target.value.split(";").map((w) => w.trim()).filter(Boolean) }) })),
    el("label", { class: "check" }, el("input", { type: "checkbox", name: "eer", checked: p.eer === "1", onchange: (e) => change({ eer: e.target.checked ? "1" : "" }) }), "with an EER"));
}

const words = new Set(["hash", "state", "class", "fidelity", "wanted", "settled", "stale"]);

function head_cell(column, sort, change) {
  const falling = sort === `-${column.name}`, rising = sort === column.name;
  const next = rising ? `-${column.name}` : falling ? "" : column.name;
  return el("th", { scope: "col", class: words.has(column.name) ? "" : "number", "aria-sort": rising ? "ascending" : falling ? "descending" : "none" },
    el("button", { type: "button", class: "sort", title: column.meaning, onclick: () => change({ sort: next }) },
      heads[column.name] ?? column.name, rising ? " ↑" : falling ? " ↓" : ""));
}

function row_of(columns, row, chosen, on_choice) {
  const hash = row[0];
  return el("tr", {}, el("td", {}, el("input", { type: "checkbox", "aria-label": `choose ${hash.slice(0, 8)}`, checked: chosen.has(hash), onchange: (e) => { e.target.checked ? chosen.add(hash) : chosen.delete(hash); on_choice(); } })),
    columns.map((column, k) => {
      if (column.name === "hash") return el("td", {}, el("a", { class: "hash", href: `/job/${hash}` }, cell(hash, "hash")));
      if (column.name === "state") return el("td", {}, el("span", { class: `badge is-${row[k]}` }, row[k]));
      return el("td", { class: words.has(column.name) ? "" : "number" }, cell(row[k], column.name));
    }));
}

function pager(total, offset, change) {
  const last = Math.max(0, Math.floor((total - 1) / page_size) * page_size);
  const button = (text, label, to, off) => el("button", { type: "button", "aria-label": label, disabled: off, onclick: () => change({ offset: to }) }, text);
  return el("div", { class: "pager" }, button("«", "first page", 0, offset === 0), button("‹", "page before", Math.max(0, offset - page_size), offset === 0),
    el("span", {}, total === 0 ? "no job" : `${whole(offset + 1)}–${whole(Math.min(total, offset + page_size))} of ${whole(total)}`),
    button("›", "next page", offset + page_size, offset + page_size >= total), button("»", "last page", last, offset >= last));
}

export async function show_jobs(root, { signal, query, note }) {
  const p = parameters_of(query);
  const chosen = new Set();
  const table = el("div", { class: "stack" }), tools = el("div", { class: "row tools" });
  const form = el("div", {});
  let page = null;
  const change = (what) => {
    Object.assign(p, "offset" in what ? {} : { offset: 0 }, what);
    note({ ...p, offset: p.offset || "" });
    if (!("offset" in what) && !("sort" in what)) draw_form();
    load().catch((problem) => signal.aborted || fill(table, el("p", { class: "empty problem" }, problem.message)));
  };
  let sweeps = [];
  const draw_form = () => fill(form, filter_form(p, sweeps, change));
  const draw_tools = () => fill(tools,
    el("a", { class: "button", href: `/api/jobs.csv${query_of({ ...p, offset: "" })}`, download: "jobs.csv" }, "Export CSV"),
    el("a", { class: "button", "aria-disabled": chosen.size < 2 || chosen.size > 4, href: chosen.size >= 2 && chosen.size <= 4 ? `/compare?jobs=${[...chosen].join(",")}` : null }, `Compare${chosen.size ? ` ${chosen.size}` : ""} (2 to 4)`),
    may_act() && chosen.size > 0 && action_bar({ selection: { hashes: [...chosen] } }, { stale: true }));
  const draw = () => {
    draw_tools();
    fill(table, page.shared.length > 0 && page.total > 1 && el("p", { class: "shared" }, "All have ", page.shared.filter((s) => s.value !== null && !(s.name === "wanted" && s.value === "run") && !(s.name === "priority" && s.value === 0)).map((s) =>
      el("span", { title: s.meaning }, heads[s.name] ?? s.name, " ", el("b", {}, cell(s.value, s.name))))),
      pager(page.total, p.offset, change),
      el("div", { class: "scroll" }, el("table", { class: "jobs" }, el("thead", {}, el("tr", {}, el("th", {}), page.columns.map((c) => head_cell(c, p.sort, change)))),
        el("tbody", {}, page.rows.map((row) => row_of(page.columns, row, chosen, draw_tools))))),
      page.total > page_size && pager(page.total, p.offset, change));
  };
  const load = async () => {
    page = await get("jobs", { ...p, limit: page_size }, signal);
    draw();
  };
  fill(root, el("h1", {}, "Jobs"), form, tools, table);
  draw_form();
  get("campaign", {}, signal).then((c) => { sweeps = [...new Set(c.sweeps.map((s) => s.name))]; draw_form(); }).catch(() => {});
  try {
    await load();
  } catch (problem) {
    if (signal.aborted) return;
    fill(table, el("p", { class: "empty problem" }, problem.message));
  }
  let heard = 0;
  const again = gently(() => load().catch(() => {}), 3000);
  listen((kind) => kind === "database" && heard++ > 0 && again(), signal);
}
