// When which worker was at work: a lane each, an attempt a bar.

import { el, fill, svg } from "./dom.js";
import { linear } from "./chart.js";
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

function clock_ticks(from, to, most) {
  const steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200, 86400, 172800, 604800];
  const step = 1000 * (steps.find((s) => (to - from) / (1000 * s) <= most) ?? 2592000);
  const found = [];
  for (let t = Math.ceil(from / step) * step; t <= to; t += step) found.push(t);
  return found.map((t) => [t, new Date(t).toISOString().slice(step < 60000 ? 11 : step < 86400000 ? 11 : 5, step < 60000 ? 19 : step < 86400000 ? 16 : 10)]);
}

function draw(picture, spans, width) {
  const now = Date.now();
  const lanes = lanes_of(spans, now).slice(0, 64);
  const tall = lanes.length > 24 ? 8 : 16, left = 8, right = 8, top = 4;
  const from = Math.min(...lanes.flatMap((l) => l.spans.map((s) => s.from)));
  const to = Math.max(...lanes.flatMap((l) => l.spans.map((s) => s.to)), from + 1000);
  const x = linear(from, to, left, width - right);
  const height = top + lanes.length * tall + 24;
  picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
  picture.setAttribute("height", height);
  fill(picture, clock_ticks(from, to, Math.floor(width / 74)).map(([t, text]) => [
    svg("path", { class: "grid", d: `M${x(t)} ${top}V${height - 20}` }),
    svg("text", { x: Math.min(Math.max(x(t), 26), width - 26), y: height - 6, "text-anchor": "middle" }, text)]),
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
