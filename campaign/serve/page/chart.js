// Scales, ticks and line charts in SVG.

import { el, fill, svg } from "./dom.js";
import { digits } from "./format.js";

export function linear(low, high, from, to) {
  const scale = (value) => from + ((value - low) / (high - low || 1)) * (to - from);
  scale.back = (place) => low + ((place - from) / (to - from)) * (high - low);
  return scale;
}

/// Multiples of 1, 2 or 5 times a power of ten, at most so many.
export function ticks(low, high, most = 6) {
  if (!(high > low)) return [low];
  const rough = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => (high - low) / s <= most);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) found.push(Number((k * step).toPrecision(12)));
  return found;
}

/// The number of a tick: short, whatever its size.
function tick_text(value) {
  const magnitude = Math.abs(value);
  return magnitude !== 0 && (magnitude >= 1e5 || magnitude < 1e-3) ? String(Number(value.toPrecision(3)).toExponential()).replace("e+", "e") : digits(value, 3);
}

/// A line chart. `lines`: [{name, x, y, kind}], kind: 1 to 4, the way that it is drawn. Options:
/// title, unit, x_label, low, high, marks [{y, text}]. Gives the node, with .point_at(x) for a
/// moment chosen elsewhere.
export function line_chart(lines, options = {}) {
  const node = el("figure", { class: "chart" });
  const picture = svg("svg", { role: "img", "aria-label": options.title });
  const reading = el("output", { class: "reading" });
  node.append(el("figcaption", {}, el("b", {}, options.title), options.unit && el("span", { class: "unit" }, options.unit),
    el("span", { class: "keys" }, lines.map((line) => el("span", { class: `key line-${line.kind}` },
      svg("svg", { width: 18, height: 8, viewBox: "0 0 18 8", "aria-hidden": "true" }, svg("path", { d: "M0 4H18", class: `line line-${line.kind}` })), line.name)))),
    picture, reading);
  let chosen = null;
  let draw_point = () => {};
  const draw = () => {
    const width = Math.max(220, node.clientWidth), height = 150;
    draw_point = plot(picture, reading, lines, options, width, height);
    draw_point(chosen);
  };
  node.point_at = (x) => { chosen = x; draw_point(x); };
  new ResizeObserver(draw).observe(node);
  return node;
}

function plot(picture, reading, lines, options, width, height) {
  const left = 46, right = 10, top = 8, bottom = 24;
  const xs = lines.flatMap((l) => l.x), ys = lines.flatMap((l) => l.y).filter(Number.isFinite);
  const x = linear(Math.min(...xs), Math.max(...xs), left, width - right);
  let low = options.low ?? Math.min(...ys), high = options.high ?? Math.max(...ys);
  if (!(high > low)) low -= Math.abs(low) * 0.05 || 0.5, high += Math.abs(high) * 0.05 || 0.5;
  const y = linear(low, high, height - bottom, top);
  const x_ticks = ticks(Math.min(...xs), Math.max(...xs), Math.floor(width / 90));
  picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
  picture.setAttribute("height", height);
  const cursor = svg("g", { class: "cursor" });
  fill(picture,
    ticks(low, high, 4).map((t) => [svg("path", { class: "grid", d: `M${left} ${y(t)}H${width - right}` }),
      svg("text", { x: left - 6, y: y(t) + 4, "text-anchor": "end" }, tick_text(t))]),
    x_ticks.map((t) => svg("text", { x: Math.min(x(t), width - 20), y: height - 8, "text-anchor": "middle" }, digits(t, 5))),
    (options.marks ?? []).map((m) => svg("path", { class: "mark", d: `M${left} ${y(m.y)}H${width - right}` })),
    lines.map((line) => svg("path", { class: `line line-${line.kind}`, d: path_of(line, x, y) })), cursor);
  const show = (value) => {
    if (value === null || !xs.length) return void fill(cursor), void fill(reading);
    const k = nearest(lines[0].x, value);
    const at = x(lines[0].x[k]);
    fill(cursor, svg("path", { d: `M${at} ${top}V${height - bottom}` }));
    fill(reading, `${options.x_name ?? "t"} ${digits(lines[0].x[k], 5)}: `,
      lines.map((l) => `${l.name} ${digits(l.y[nearest(l.x, value)], 4)}`).join(" · "));
  };
  picture.onpointermove = (event) => {
    const box = picture.getBoundingClientRect();
    show(x.back(((event.clientX - box.left) / box.width) * width));
  };
  picture.onpointerleave = () => show(null);
  return show;
}

function nearest(values, value) {
  let best = 0;
  for (let k = 1; k < values.length; ++k) if (Math.abs(values[k] - value) < Math.abs(values[best] - value)) best = k;
  return best;
}

function path_of(line, x, y) {
  let text = "", pen = "M";
  for (let k = 0; k < line.x.length; ++k) {
    if (!Number.isFinite(line.y[k])) { pen = "M"; continue; }
    text += `${pen}${x(line.x[k]).toFixed(1)} ${y(line.y[k]).toFixed(1)}`;
    pen = "L";
  }
  return text;
}
