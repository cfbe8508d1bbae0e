// A map of impacts over speed and angle, its cells filling in while the campaign runs.

import { get } from "./api.js";
import { el, fill, select } from "./dom.js";
import { gently, listen } from "./events.js";
import { digits, fixed, none, percent, short, whole } from "./format.js";
import { draw_map } from "./map_picture.js";
import { legend } from "./map_legend.js";

const group_of = (m) => `${m.q},${m.phi_d_deg}`;
const name_of = (m) => `${m.fidelity || `settings ${m.settings}`} · ${whole(m.particles_per_target)} particles`;

/// From the coarsest settings to the finest: how the slider goes.
const by_fineness = (a, b) => a.particles_per_target - b.particles_per_target || a.settings - b.settings;

function chosen_map(maps, query) {
  const wanted = maps.filter((m) => (!query.get("q") || m.q === Number(query.get("q"))) && (!query.get("phi_d") || m.phi_d_deg === Number(query.get("phi_d"))));
  const pool = wanted.length ? wanted : maps;
  return pool.find((m) => m.settings === Number(query.get("settings"))) ?? pool.reduce((best, m) => (m.done > best.done ? m : best), pool[0]);
}

function mean_text([mean, deviation], unit = "", places = 3) {
  if (mean === null) return none;
  return `${fixed(mean, places)}${deviation === null ? "" : ` ± ${fixed(deviation, places)}`}${unit}`;
}

export function cell_facts(cell) {
  const rows = [["speed", `${digits(cell.v)} cm/s = ${fixed(cell.v_over_v_esc)} v_esc`], ["angle", `${digits(cell.theta)}°`]];
  if (cell.results) rows.push(
    ["outcome", Object.entries(cell.classes).map(([c, n]) => (cell.results > 1 ? `${n} × ${c}` : c)).join(", ")],
    ["b/a", mean_text(cell.b_over_a)], ["c/a", mean_text(cell.c_over_a)], ["M_lr/M", mean_text(cell.m_lr_over_m_total)],
    ["period", mean_text(cell.period_h, " h", 1)], ["EERs", mean_text(cell.n_eer, "", 2)]);
  rows.push(["seeds", `${cell.results} of ${cell.jobs} done${cell.failed ? `, ${cell.failed} failed` : ""}${cell.running.length ? `, ${cell.running.length} at work` : ""}`]);
  if (cell.unsettled) rows.push(["unsettled", `${cell.unsettled}: remnants will meet again`]);
  if (cell.stale) rows.push(["stale", `${cell.stale} made by another solver version`]);
  return rows;
}

const facts = (rows) => el("dl", { class: "facts" }, rows.map(([k, v]) => [el("dt", {}, k), el("dd", {}, v)]));

export async function show_map(root, { signal, query, go, note }) {
  const { maps } = await get("maps", {}, signal);
  if (maps.length === 0) return void fill(root, el("h1", {}, "Map"), el("p", { class: "empty" }, "The database holds no job yet."));
  let here = chosen_map(maps, query), quantity = query.get("quantity") || "b/a", map = null, ridge = null;
  let progress = {}, selected = query.get("cell") ?? "";
  const controls = el("div", { class: "row controls" }), picture = el("div", { class: "picture" }), side = el("aside", { class: "side" });
  const hover = el("div", { class: "hover", hidden: true });
  const state = () => ({ q: here.q, phi_d: here.phi_d_deg, settings: here.settings, quantity: quantity === "b/a" ? "" : quantity, cell: selected });
  const keep = () => note(state());
  const filter = () => ({ q: here.q, phi_d: here.phi_d_deg, settings: here.settings });

  const open = async (cell) => {
    selected = `${cell.v},${cell.theta}`;
    keep();
    const { jobs } = await get("cell", { ...filter(), v: cell.v, theta: cell.theta }, signal);
    if (jobs.length === 1) return void go(`/job/${jobs[0].hash}`);
    draw_side(cell, jobs);
  };
  const show_hover = (cell, box) => {
    hover.hidden = !cell;
    if (!cell) return;
    fill(hover, el("b", {}, cell.state === "running" && progress[cell.running[0]] ? `running, ${percent(progress[cell.running[0]].part)}` : cell.state), facts(cell_facts(cell)));
    const room = picture.getBoundingClientRect();
    const left = Math.min(Math.max(0, box.left + box.width / 2 - room.left - 120), Math.max(0, room.width - 248));
    const above = box.top - room.top > hover.offsetHeight + 8;
    hover.style.setProperty("left", `${left}px`);
    hover.style.setProperty("top", `${above ? box.top - room.top - hover.offsetHeight - 8 : box.bottom - room.top + 8}px`);
  };
  const draw_side = (cell = null, jobs = []) => fill(side, legend(map, quantity, ridge),
    cell && el("section", { class: "chosen" }, el("h2", {}, `${digits(cell.v)} cm/s, ${digits(cell.theta)}°`),
      el("table", {}, el("thead", {}, el("tr", {}, ["seed", "job", "state", "class", "b/a"].map((t) => el("th", {}, t)))),
        el("tbody", {}, jobs.slice(0, 12).map((j) => el("tr", {}, el("td", {}, j.seed), el("td", {}, el("a", { class: "hash", href: `/job/${j.hash}` }, short(j.hash))),
          el("td", {}, j.state), el("td", {}, j.class ?? none), el("td", { class: "number" }, j.b_over_a === null ? none : fixed(j.b_over_a, 3)))))),
      jobs.length > 12 && el("p", {}, el("a", { href: `/jobs?q=${here.q}&phi_d=${here.phi_d_deg}&v=${cell.v}&theta=${cell.theta}&settings=${here.settings}` }, `all ${whole(jobs.length)} jobs`)),
      el("p", { class: "row" }, el("a", { class: "button", href: `/compare?jobs=${jobs.slice(0, 4).map((j) => j.hash).join(",")}` }, "Compare seeds"),
        finer().length > 1 && el("a", { class: "button", href: `/compare?cells=${finer().slice(0, 4).map((m) => [m.q, m.phi_d_deg, cell.v, cell.theta, m.settings].join("_")).join(",")}` }, "Compare fidelities"))));
  const finer = () => maps.filter((m) => group_of(m) === group_of(here)).sort(by_fineness);

  const draw_controls = () => {
    const groups = [...new Map(maps.map((m) => [group_of(m), m])).values()];
    const steps = finer();
    const label = el("output", {}, name_of(here));
    const slider = el("input", { type: "range", min: 0, max: Math.max(0, steps.length - 1), step: 1, value: steps.indexOf(here), disabled: steps.length < 2, "aria-label": "Fidelity",
      "aria-valuetext": name_of(here), oninput: () => { here = steps[Number(slider.value)]; fill(label, name_of(here)); keep(); load(); } });
    fill(controls,
      select("bodies", groups.map((m) => [group_of(m), `q ${digits(m.q)}, φ_d ${digits(m.phi_d_deg)}°`]), group_of(here), (value) => {
        here = maps.filter((m) => group_of(m) === value).reduce((best, m) => (m.done > best.done ? m : best)); selected = ""; keep(); draw_controls(); load(); }),
      select("quantity", (map?.quantities ?? [{ token: "b/a", title: "b/a of the largest remnant" }]).map((q) => [q.token, q.title]), quantity, (value) => { quantity = value; keep(); draw(); }),
      el("label", { class: "field grow" }, el("span", {}, "fidelity"), el("span", { class: "row" }, slider, label)));
  };
  const draw = () => {
    draw_map(picture, { map, quantity, ridge, progress, selected, open, show_hover });
    picture.append(hover);
    draw_side();
  };
  const load = async () => {
    const asked = here;
    const found = await get("map", filter(), signal);
    if (asked !== here) return;
    const first = map === null;
    map = found;
    if (first) draw_controls();
    draw();
  };
  const load_ridge = async () => {
    const asked = here;
    const found = await get("ridge", filter(), signal);
    if (asked !== here) return;
    ridge = { ...found, settings: here.settings };
    if (map) draw();
  };
  const caught = (problem) => signal.aborted || fill(picture, el("p", { class: "empty problem" }, problem.message));
  const ridge_again = gently(() => load_ridge().catch(() => {}), 5000);

  fill(root, el("h1", { class: "quiet" }, "Map"), controls, el("div", { class: "map" }, picture, side));
  await load();
  ridge_again();
  const again = gently(() => load().then(ridge_again).catch(caught), 1000);
  new ResizeObserver(() => map && draw()).observe(root);
  let heard = 0;
  listen((kind, data) => {
    if (kind === "database" && heard++ > 0) again();
    if (kind === "progress") { progress = data; if (map?.cells.some((c) => c.running.length)) draw(); }
  }, signal);
}
