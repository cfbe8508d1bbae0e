// When which worker was at work: a lane each, an attempt a bar.

import { el, fill, svg } from "./dom.js";
import { axis } from "./chart.js";
import { duration, short } from "./format.js";

const time_of = (iso) => Date.parse(iso);

/// Attempts in lanes, as few as hold them without overlap, host by host.
function lanes_of(spans, now) {
  const lanes = [];
  const sorted = spans.map((s) => ({ ...s, from: time_of(s.started), to: s.ended ? time_of(s.ended) : now }))
    .sort((a, b) => a.host.localeCompare(b.host) || a.from - b.from);
  for (const span of sorted) {
    let lane = lanes.find((l) => l.host === span.host && l.free <= span.from);
    if (!lane) lanes.push((lane = { host: span.host, spans: [] }));
    lane.spans.push(span);
    lane.free = span.to;
  }
  return lanes;
}

function kind_of(span) {
  if (!span.ended) return "running";
  return { finished: "done", failed: "failed", crashed: "failed" }[span.exit_reason] ?? "paused";
}

/// The time of day, and the date where it changes.
const clock = d3.time.format.utc.multi([
  ["%H:%M:%S", (t) => t.getUTCSeconds()],
  ["%H:%M", (t) => t.getUTCHours() || t.getUTCMinutes()],
  ["%b %-d", (t) => t.getUTCMonth() || t.getUTCDate() > 1],
  ["%Y", () => true]]);

function draw(picture, spans, width) {
  const now = Date.now();
  const lanes = lanes_of(spans, now).slice(0, 64);
  const tall = lanes.length > 24 ? 8 : 16, left = 8, right = 8, top = 4;
  const shown = lanes.flatMap((l) => l.spans), from = d3.min(shown, (s) => s.from);
  const x = d3.time.scale.utc().domain([from, Math.max(d3.max(shown, (s) => s.to), from + 1000)]).range([left, width - right]);
  const bottom = top + lanes.length * tall, height = bottom + 24;
  picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
  picture.setAttribute("height", height);
  // At the very ends there is no room for a time.
  const times = x.ticks(Math.max(2, Math.floor(width / 90))).filter((t) => x(t) > 28 && x(t) < width - 28);
  fill(picture, axis(x, "bottom", [0, bottom], { values: times, text: clock, grid: bottom - top }),
    lanes.map((lane, k) => lane.spans.map((s) => svg("a", { href: `/job/${s.hash}`, tabindex: -1 },
    svg("rect", { class: `span is-${kind_of(s)}`, x: x(s.from), y: top + k * tall + 1, rx: 2,
      width: Math.max(2, x(s.to) - x(s.from) - 1), height: tall - 2 },
    svg("title", {}, `${short(s.hash)} on ${s.host}, ${duration((s.to - s.from) / 1000)}, ${s.ended ? s.failure_kind || s.exit_reason : "at work"}`))))));
}

export function timeline(spans) {
  if (spans.length === 0) return el("section", { class: "card" }, el("h2", {}, "Workers"), el("p", { class: "empty" }, "No worker was started yet."));
  const hosts = [...new Set(spans.map((s) => s.host))];
  const picture = svg("svg", { role: "img", "aria-label": "Workers over time" });
  const node = el("section", { class: "card timeline" }, el("h2", {}, "Workers", el("small", {}, ` the newest ${spans.length} attempts on ${hosts.join(", ")}, UTC`)), picture,
    el("ul", { class: "counts" }, [["done", "finished"], ["running", "at work"], ["paused", "stopped or lost"], ["failed", "failed or crashed"]]
      .map(([s, text]) => el("li", {}, el("i", { class: `dot is-${s}` }), ` ${text}`))));
  new ResizeObserver(() => picture.clientWidth && draw(picture, spans, node.clientWidth - 32)).observe(node);
  return node;
}
