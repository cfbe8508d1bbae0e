// What the colours and marks of a map mean.

import { axis } from "./chart.js";
import { el, svg } from "./dom.js";
import { digits, fixed } from "./format.js";

function scale_bar({ scale }) {
  const width = 240, height = 14;
  const part = (scale.logarithmic ? d3.scale.log() : d3.scale.linear()).domain([scale.low, scale.high]).range([0, width]);
  const step = width / scale.stops.length;
  return svg("svg", { viewBox: `-10 0 ${width + 20} ${height + 20}`, class: "scale", role: "img", "aria-label": `from ${scale.low} to ${scale.high}` },
    scale.stops.map((colour, k) => svg("rect", { x: k * step, y: 0, width: step + 0.5, height, fill: colour })),
    axis(part, "bottom", [0, height], { values: scale.ticks, text: (value) => digits(value, 3), tick: 4, padding: 3 }));
}

function classes_key(map) {
  const there = new Set(map.cells.map((c) => c.class));
  return el("ul", { class: "keys" }, map.classes.filter((c) => there.has(c.name)).map((c) =>
    el("li", {}, svg("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("rect", { width: 16, height: 16, rx: 2, fill: c.colour })), el("b", {}, c.letter), ` ${c.name}`)));
}

const frame = { x: 0.5, y: 0.5, width: 15, height: 15 };
const samples = {
  eer: ["half and more EERs (b/a < 0.3)", () => ["eer-halo", "eer-outline"].map((kind) => svg("rect", { x: 2, y: 2, width: 12, height: 12, class: kind }))],
  smaller: ["a smaller remnant is an EER", () => [svg("rect", { ...frame, class: "sample" }), svg("path", { class: "corner", d: "M15.5 0.5v9l-9 -9z" })]],
  unsettled: ["unsettled: will meet again", () => [svg("rect", { ...frame, class: "sample" }), svg("rect", { ...frame, fill: "url(#hatch)" })]],
  stale: ["stale: another solver version", () => [svg("rect", { ...frame, class: "sample" }), svg("rect", { ...frame, fill: "url(#rule)" })]],
  running: ["running", () => [svg("rect", { ...frame, class: "at-work" }), svg("rect", { ...frame, y: 8, height: 7.5, class: "progress" }), svg("rect", { ...frame, class: "at-work-frame" })]],
  pending: ["pending", () => [svg("rect", { ...frame, class: "pending" }), svg("circle", { cx: 8, cy: 8, r: 3, class: "ring" })]],
  failed: ["failed", () => [svg("rect", { ...frame, class: "failed" }), svg("path", { class: "cross", d: "M4 4l8 8m0 -8l-8 8" })]],
  cancelled: ["cancelled", () => [svg("rect", { ...frame, class: "cancelled" }), svg("path", { class: "dash", d: "M4 8h8" })]],
  missing: ["no job here", () => svg("circle", { cx: 8, cy: 8, r: 1.5, class: "missing" })],
};

function marks(map) {
  const has = {
    eer: map.cells.some((c) => c.is_eer), smaller: map.cells.some((c) => c.smaller_eer), unsettled: map.cells.some((c) => c.unsettled), stale: map.cells.some((c) => c.stale),
    missing: map.cells.length < map.v.at.length * map.theta.at.length,
  };
  for (const state of ["running", "pending", "failed", "cancelled"]) has[state] = map.cells.some((c) => c.state === state || (state === "running" && c.running.length));
  return el("ul", { class: "keys" }, Object.entries(samples).filter(([name]) => has[name]).map(([, [text, draw]]) =>
    el("li", {}, svg("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" }, draw()), text)));
}

function curves(map, ridge) {
  const line = (kind) => svg("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { class: kind, d: "M0 8H16" }));
  return el("ul", { class: "keys" },
    map.paper_cm_per_s && el("li", {}, line("paper"), `paper: v sin θ = ${digits(map.paper_cm_per_s)} cm/s`),
    ridge?.settings === map.settings && ridge.constant && el("li", {}, line("fitted"), `fitted: ${fixed(ridge.constant)} (95 %: ${fixed(ridge.low)} to ${fixed(ridge.high)}) cm/s`),
    ridge?.settings === map.settings && ridge.reason && el("li", { class: "hint" }, el("details", {}, el("summary", {}, "no curve is fitted"), ridge.reason)));
}

export function legend(map, quantity, ridge) {
  const shown = map.quantities.find((q) => q.token === quantity) ?? map.quantities[0];
  return el("section", { class: "legend" }, el("h2", {}, shown.title), shown.token === "class" ? classes_key(map) : scale_bar(shown), marks(map), curves(map, ridge));
}
