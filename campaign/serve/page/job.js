// A job: what happened, first as a picture; its numbers over time, its remnants, scene, attempts, log.

import { get } from "./api.js";
import { action_bar } from "./actions.js";
import { el, fill } from "./dom.js";
import { gently, listen } from "./events.js";
import { cell, digits, duration, fixed, magnitude, moment, none, percent, short, whole } from "./format.js";
import { live_log } from "./log.js";
import { series } from "./series.js";

function badge(job) {
  const wanted = job.wanted === "run" ? "" : job.wanted === "pause" ? ", paused" : ", being cancelled";
  return el("span", { class: `badge is-${job.wanted === "pause" ? "paused" : job.state}` }, job.state + wanted);
}

export function numbers_of(job) {
  const outcome = job.result?.analysis.outcome, largest = job.result?.analysis.remnants[0], run = job.result?.run;
  return [["outcome", outcome?.class ?? none], ["b/a", fixed(largest?.b_over_a, 3)], ["c/a", fixed(largest?.c_over_a, 3)],
    ["M_lr / M", fixed(outcome?.m_lr_over_m_total, 3)], ["spin period", largest?.spin_period_h ? `${fixed(largest.spin_period_h, 1)} h` : none],
    ["ended", run ? `${digits(run.end_time_s ?? run.ended_at_s, 5)} s${run.end_reason ? `, ${run.end_reason}` : ""}` : none], ["wall time", run ? duration(run.wall_s) : none]];
}

function head(job) {
  const { impact, material, numerics } = job.scene, outcome = job.result?.analysis.outcome;
  const p = job.progress;
  const part = p && !job.result && p.expected_end_s > 0 ? Math.min(1, p.time_s / p.expected_end_s) : null;
  const bar = el("progress", { max: 1, value: part ?? 0 });
  return el("section", { class: "card job-head" },
    el("p", { class: "row" }, badge(job), el("b", {}, `${digits(impact.v_imp_cm_per_s)} cm/s at ${digits(impact.theta_imp_deg)}°`),
      el("span", {}, `q ${digits(impact.q)}`), el("span", {}, `φ_d ${digits(material.drucker_prager.phi_d_deg)}°`), el("span", {}, `${whole(numerics.particles_per_target)} particles`), el("span", {}, `seed ${numerics.seed}`),
      el("span", {}, "in ", job.sweeps.map((s, k) => [k ? ", " : "", el("a", { href: `/jobs?sweep=${encodeURIComponent(s)}` }, s)]))),
    part !== null && el("p", { class: "row" }, bar, el("span", {}, `${percent(part)}: ${digits(p.time_s, 4)} of about ${digits(p.expected_end_s, 4)} s, step ${whole(p.step)}, ${magnitude(p.particle_steps)} particle-steps`)),
    job.result && el("dl", { class: "figures compact" }, numbers_of(job).map(([k, v]) => el("div", { class: "figure" }, el("dt", {}, k), el("dd", {}, v)))),
    outcome && !outcome.settled && el("p", { class: "waits" }, "Not settled: ", outcome.unsettled_reason),
    job.failure && el("p", { class: "waits problem" }, el("b", {}, job.failure.kind), " ", job.failure.message),
    action_bar({ selection: { hashes: [job.hash] } }, { pending: job.state === "pending", running: job.state === "running", paused: job.wanted === "pause", failed: job.state === "failed" || job.state === "cancelled", stale: false }));
}

const remnant_columns = [["rank", ""], ["particles", ""], ["mass_over_total", "M/M_total", 4], ["a_m", "a, m", 1], ["b_m", "b, m", 1], ["c_m", "c, m", 1], ["b_over_a", "b/a", 3], ["c_over_a", "c/a", 3],
  ["spin_period_h", "period, h", 2], ["shape_class", "shape"], ["target_fraction", "from target", 2], ["bound_group", "bound group"], ["eer", "EER"]];

function remnants(job) {
  const rows = job.result?.analysis.remnants ?? [];
  return rows.length > 0 && el("section", { class: "card" }, el("h2", {}, "Remnants"), el("div", { class: "scroll" }, el("table", {},
    el("thead", {}, el("tr", {}, remnant_columns.map(([name, title]) => el("th", { class: "number" }, title || name)))),
    el("tbody", {}, rows.map((r) => el("tr", {}, remnant_columns.map(([name, , places]) => el("td", { class: "number" }, places !== undefined ? fixed(r[name] ?? NaN, places) : cell(r[name], name)))))))));
}

function scene(job) {
  const row = (leaf) => el("tr", { class: leaf.differs ? "differs" : "" }, el("th", { scope: "row", title: leaf.meaning }, leaf.path), el("td", {}, JSON.stringify(leaf.value)), el("td", { class: "quiet" }, leaf.differs ? `instead of ${JSON.stringify(leaf.default)}` : ""));
  const table = (leaves) => el("table", { class: "leaves" }, el("tbody", {}, leaves.map(row)));
  const differing = job.leaves.filter((l) => l.differs);
  return el("section", { class: "card" }, el("h2", {}, "Scene"), differing.length ? table(differing) : el("p", {}, "All as by default."),
    el("details", {}, el("summary", {}, `${job.leaves.length - differing.length} fields as by default`), table(job.leaves.filter((l) => !l.differs))));
}

function pairs(object) {
  return el("dl", { class: "facts" }, Object.entries(object).map(([k, v]) => [el("dt", {}, k), el("dd", {}, typeof v === "object" ? JSON.stringify(v) : v)]));
}

function attempts(job) {
  return el("section", { class: "card" }, el("h2", {}, "Attempts"), job.attempts.length === 0 ? el("p", { class: "empty" }, "It was never started.") :
    el("div", { class: "scroll" }, el("table", {}, el("thead", {}, el("tr", {}, ["started", "ended", "because", "host", "worker", "core-time", "peak memory", "message"].map((t) => el("th", {}, t)))),
      el("tbody", {}, job.attempts.map((a) => el("tr", {}, el("td", { class: "moment" }, moment(a.started)), el("td", { class: "moment" }, moment(a.ended)), el("td", {}, a.failure_kind ?? a.exit_reason ?? "at work"), el("td", {}, a.host), el("td", {}, a.worker ?? none),
        el("td", { class: "number" }, a.core_seconds === null ? none : duration(a.core_seconds)), el("td", { class: "number" }, a.peak_memory_bytes === null ? none : `${whole(Math.round(a.peak_memory_bytes / 1e6))} MB`), el("td", {}, a.message ?? "")))))));
}

function provenance(job) {
  return el("section", { class: "card" }, el("h2", {}, "Provenance"), job.result ? pairs(job.result.provenance) : el("p", { class: "empty" }, "Told by the result."),
    el("details", {}, el("summary", {}, `${job.files.length} files`), el("p", { class: "path" }, job.directory),
      el("ul", { class: "plain" }, job.files.map((f) => el("li", {}, f.path.split("/").at(-1), " ", el("span", { class: "quiet" }, `${magnitude(f.bytes)}B`))))));
}

/// What draws particles, three.js with it: only views that do pay. Where it cannot be loaded the
/// pictures say so, and all else is shown.
export const viewer_or_reason = () => import("./viewer.js").then((all) => all.viewer)
  .catch((problem) => () => el("p", { class: "empty problem" }, `Particles cannot be drawn: ${problem.message}`));

export async function show_job(root, { signal, word }) {
  const drawing = viewer_or_reason();
  let job = await get(`job/${word}`, {}, signal);
  const address = `job/${job.hash}`;
  const top = el("div", {}), result = el("div", { class: "stack" }), history = el("div", {});
  const picture = el("section", { class: "card picture-card" }), charts = el("section", { class: "card" });
  let view = null, plots = null;
  const draw = () => {
    fill(top, head(job));
    fill(result, remnants(job), attempts(job), el("div", { class: "columns" }, scene(job), provenance(job)));
  };
  const draw_picture = async () => {
    const viewer = await drawing;
    if (signal.aborted) return;
    view = viewer(job.hash, job.snapshots, signal, { on_time: (t) => plots?.point_at(t) });
    fill(picture, el("h2", {}, "What happened"), view);
  };
  const draw_series = async () => {
    const { columns } = await get(`${address}/history`, {}, signal);
    plots = series(columns);
    fill(charts, el("h2", {}, "Over time"), plots);
  };
  draw();
  fill(root, el("h1", {}, "Job ", el("code", { title: job.hash }, short(job.hash))), top, el("div", { class: "columns wide-left" }, picture, charts), result, live_log(address, () => job.state === "running", signal));
  draw_series().catch(() => {});
  await draw_picture();
  const again = gently(async () => {
    try {
      const before = job;
      job = await get(address, {}, signal);
      if (top.contains(document.activeElement) && before.state === job.state && before.wanted === job.wanted && job.result) return;
      draw();
      if (job.snapshots.length !== before.snapshots.length) view?.add ? view.add(job.snapshots) : await draw_picture();
      if (job.state === "running" || job.state !== before.state) await draw_series();
    } catch {
      // The next news asks again.
    }
  }, 2000);
  let heard = 0;
  listen((kind, data) => {
    if (kind === "database" && heard++ > 0) again();
    if (kind === "progress" && data[job.hash]) again();
  }, signal);
}
