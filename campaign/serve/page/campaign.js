// The campaign: what is done, what is left, what it waits for, what failed, who worked when.

import { get } from "./api.js";
import { action_bar, may_act } from "./actions.js";
import { el, fill } from "./dom.js";
import { gently, listen } from "./events.js";
import { digits, duration, magnitude, none, percent, short, whole } from "./format.js";
import { submit_form } from "./submit.js";
import { timeline } from "./timeline.js";

export const states = ["done", "running", "pending", "paused", "failed", "cancelled"];

/// Pending jobs that are paused are counted as paused alone.
export function apart(jobs) {
  return { ...jobs, pending: jobs.pending - jobs.paused };
}

export function state_bar(jobs) {
  const counts = apart(jobs);
  const total = states.reduce((sum, s) => sum + counts[s], 0);
  return el("div", { class: "bar", role: "img", "aria-label": states.map((s) => `${counts[s]} ${s}`).join(", ") },
    states.filter((s) => counts[s] > 0).map((s) => {
      const part = el("span", { class: `part is-${s}`, title: `${whole(counts[s])} ${s}` });
      part.style.setProperty("flex-grow", counts[s] / total);
      return part;
    }));
}

function figure(name, value, detail) {
  return el("div", { class: "figure" }, el("dt", {}, name), el("dd", {}, value, detail && el("small", {}, detail)));
}

function head(campaign) {
  const work = campaign.at_work, jobs = apart(campaign.jobs);
  const hours = campaign.sweeps.reduce((sum, s) => (s.core_hours_left === null ? NaN : sum + s.core_hours_left), 0);
  const open = jobs.pending + jobs.running + jobs.paused > 0;
  return el("section", { class: "card", "aria-label": "Overview" },
    el("dl", { class: "figures" },
      figure("done", jobs.total ? percent(campaign.jobs.done / jobs.total) : none, `${whole(campaign.jobs.done)} of ${whole(jobs.total)} jobs`),
      figure("speed", work ? magnitude(work.particle_steps_per_s) : none, work ? "particle-steps/s" : "nobody works on it"),
      figure("time left", work && work.eta_s >= 0 ? duration(work.eta_s) : none, work ? "at this speed" : open ? "once a daemon works on it" : "nothing is left"),
      figure("core-hours left", Number.isFinite(hours) ? digits(hours, 3) : none, Number.isFinite(hours) ? "at the measured speed" : "no speed measured yet")),
    state_bar(campaign.jobs),
    el("ul", { class: "counts" }, states.map((s) =>
      el("li", {}, el("a", { href: s === "paused" ? "/jobs?where=wanted%3Dpause" : `/jobs?state=${s}` },
        el("i", { class: `dot is-${s}` }), el("b", {}, whole(jobs[s])), ` ${s}`)))),
    waits(campaign));
}

function waits(campaign) {
  const lines = [];
  if (campaign.at_work?.waiting_for) lines.push(campaign.at_work.waiting_for);
  else if (campaign.no_room) lines.push(campaign.no_room);
  if (campaign.at_work?.stopping) lines.push("Stopping: workers write their checkpoints.");
  for (const s of campaign.silent) lines.push(["Job ", el("a", { href: `/job/${s.hash}` }, short(s.hash)), ` on ${s.host} gave no sign of life for ${duration(s.seconds)}.`]);
  return lines.length > 0 && el("div", { class: "waits" }, el("b", {}, "Waits for"), lines.map((l) => el("p", {}, l)));
}

/// `open`: names of the sweeps whose actions are shown; `again` draws what has changed.
function sweeps(campaign, open, again) {
  const row = (s) => {
    const counts = apart(s.jobs);
    return el("tr", {}, el("th", { scope: "row" }, el("a", { href: `/jobs?sweep=${encodeURIComponent(s.name)}` }, s.name)),
      el("td", { class: "wide" }, state_bar(s.jobs)),
      states.map((k) => el("td", { class: "number" }, counts[k] ? whole(counts[k]) : el("span", { class: "zero" }, "0"))),
      el("td", { class: "number" }, s.jobs.stale ? whole(s.jobs.stale) : el("span", { class: "zero" }, "0")),
      el("td", { class: "number" }, s.core_hours_left === null ? none : digits(s.core_hours_left, 3)),
      may_act() && el("td", {}, el("button", { type: "button", class: "more", "aria-label": `Actions on ${s.name}`, "aria-expanded": open.has(s.name), onclick: () => { open.has(s.name) ? open.delete(s.name) : open.add(s.name); again(); } }, "…")));
  };
  const rows = (s) => [row(s), may_act() && open.has(s.name) && el("tr", {}, el("td", { class: "tools-row", colspan: 11 }, action_bar({ selection: { sweep: s.name } }, { stale: s.jobs.stale > 0 })))];
  return el("section", { class: "card" }, el("h2", {}, "Sweeps"),
    campaign.sweeps.length === 0 ? el("p", { class: "empty" }, "No sweep yet: eerie submit SWEEP gives it one.") :
    el("div", { class: "scroll" }, el("table", {}, el("thead", {}, el("tr", {}, el("th", {}, "sweep"), el("th", {}),
      [...states, "stale", "core-hours left"].map((k) => el("th", { class: "number" }, k)), may_act() && el("th", {}))),
      el("tbody", {}, campaign.sweeps.map(rows)))));
}

function failures(campaign) {
  return campaign.failures.length > 0 && el("section", { class: "card" }, el("h2", {}, "Failures by cause"),
    el("ul", { class: "failures" }, campaign.failures.map((f) => el("li", {},
      el("b", {}, `${whole(f.jobs)} × ${f.kind}`), el("p", {}, f.message, " ",
        el("a", { href: `/job/${f.hash}` }, `for example ${short(f.hash)}`))))));
}

export async function show_campaign(root, { signal }) {
  const first = el("div", { class: "stack" }), second = el("div", { class: "stack" });
  const open = new Set();
  let campaign = null;
  const show = () => fill(first, head(campaign), sweeps(campaign, open, show), failures(campaign));
  const draw = async () => {
    campaign = await get("campaign", {}, signal);
    show();
  };
  const spans = async () => fill(second, timeline((await get("timeline", {}, signal)).spans));
  await draw();
  fill(root, el("h1", { class: "quiet" }, "Campaign"), first, second, may_act() && submit_form());
  spans();
  const again = gently(() => Promise.all([draw(), spans()]).catch(() => {}), 2000);
  let heard = 0;
  listen((kind) => {
    // What is told at once is what has just been drawn.
    if ((kind === "database" || kind === "work") && heard++ >= 2) again();
  }, signal);
}
