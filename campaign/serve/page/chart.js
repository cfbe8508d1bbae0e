// Scales, axes and line charts in SVG, by d3 (index.html puts it into the window).

import { el, fill, svg } from "./dom.js";
import { digits } from "./format.js";

/// The axis of a scale as a group, at its place. `grid`: how far lines reach into the picture.
export function axis(scale, orient, [x, y], { values = null, count = 6, text = null, grid = 0, tick = 0, padding = 6 } = {}) {
  const made = d3.svg.axis().scale(scale).orient(orient).ticks(count).tickValues(values).tickFormat(text)
    .innerTickSize(grid ? -grid : tick).outerTickSize(0).tickPadding(padding);
  const node = svg("g", { class: `axis-lines${grid ? " with-grid" : ""}`, transform: `translate(${x} ${y})` });
  d3.select(node).call(made);
  return node;
}

/// The numbers of a scale's ticks: short, whatever their size, and told apart.
function tick_text(scale, count) {
  const most = d3.max(scale.domain(), Math.abs);
  if (most === 0 || (most >= 1e-2 && most < 1e5)) return scale.tickFormat(count);
  const text = scale.tickFormat(count, "e");
  return (value) => (value === 0 ? "0" : text(value).replace("e+", "e"));
}

/// A line chart. `lines`: [{name, x, y, kind}], x ascending, kind: 1 to 4, the way that it is drawn.
/// Options: title, unit, x_name, low, high, marks [{y, text}]. Gives the node, with .point_at(x) for
/// a moment chosen elsewhere.
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
  const right = width - 22, top = 8, bottom = height - 24, across = 4;
  let [low, high] = d3.extent(lines.flatMap((l) => l.y).filter(Number.isFinite));
  low = options.low ?? low, high = options.high ?? high;
  if (!(high > low)) low -= Math.abs(low) * 0.05 || 0.5, high += Math.abs(high) * 0.05 || 0.5;
  const y = d3.scale.linear().domain([low, high]).range([bottom, top]), text = tick_text(y, across);
  const left = Math.max(46, 12 + 7 * d3.max(y.ticks(across), (t) => text(t).length));
  const x = d3.scale.linear().domain(d3.extent(lines.flatMap((l) => l.x))).range([left, right]);
  const path = (l) => d3.svg.line().defined((k) => Number.isFinite(l.y[k])).x((k) => x(l.x[k])).y((k) => y(l.y[k]))(d3.range(l.x.length));
  picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
  picture.setAttribute("height", height);
  const cursor = svg("g", { class: "cursor" });
  fill(picture, axis(y, "left", [left, 0], { count: across, text, grid: right - left }), axis(x, "bottom", [0, bottom], { count: Math.max(2, Math.floor((right - left) / 80)) }),
    (options.marks ?? []).map((m) => svg("path", { class: "mark", d: `M${left} ${y(m.y)}H${right}` })),
    lines.map((l) => svg("path", { class: `line line-${l.kind}`, d: path(l) })), cursor);
  const show = (value) => {
    if (value === null || lines.length === 0) return void fill(cursor), void fill(reading);
    const at = lines[0].x[nearest(lines[0].x, value)];
    fill(cursor, svg("path", { d: `M${x(at)} ${top}V${bottom}` }));
    fill(reading, `${options.x_name ?? "t"} ${digits(at, 5)}: `,
      lines.map((l) => `${l.name} ${digits(l.y[nearest(l.x, value)], 4)}`).join(" · "));
  };
  picture.onpointermove = (event) => {
    const box = picture.getBoundingClientRect();
    show(x.invert(((event.clientX - box.left) / box.width) * width));
  };
  picture.onpointerleave = () => show(null);
  return show;
}

/// Where in ascending values the one is that lies nearest.
function nearest(values, value) {
  const k = d3.bisectLeft(values, value, 1, values.length - 1);
  return value - values[k - 1] < values[k] - value ? k - 1 : k;
}
