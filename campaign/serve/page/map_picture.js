// The map as vector graphics: cells, marks of their states, the outline of EERs, curves, axes.

import { fill, svg } from "./dom.js";
import { axis } from "./chart.js";
import { digits, percent } from "./format.js";

const margin = { left: 56, right: 12, top: 44, bottom: 46 };

export function draw_map(place, view) {
  const { map } = view;
  const width = Math.max(280, place.clientWidth || 640);
  const height = Math.round(Math.min(640, Math.max(340, width * 0.62)));
  const x = d3.scale.linear().domain(d3.extent(map.v.edges)).range([margin.left, width - margin.right]);
  const y = d3.scale.linear().domain(d3.extent(map.theta.edges)).range([height - margin.bottom, margin.top]);
  const focused = place.contains(document.activeElement) ? document.activeElement.dataset.cell : null;
  const at = new Map(map.cells.map((cell) => [`${cell.v},${cell.theta}`, cell]));
  const boxes = [];
  for (let j = 0; j < map.theta.at.length; ++j)
    for (let i = 0; i < map.v.at.length; ++i)
      boxes.push({ i, j, key: `${map.v.at[i]},${map.theta.at[j]}`, cell: at.get(`${map.v.at[i]},${map.theta.at[j]}`),
        left: x(map.v.edges[i]), right: x(map.v.edges[i + 1]), top: y(map.theta.edges[j + 1]), bottom: y(map.theta.edges[j]) });
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, class: "map-svg", role: "grid", "aria-label": "Map of impacts over speed and angle" },
    patterns(), svg("g", {}, boxes.map((box) => one_cell(box, view))),
    outlined(boxes, map), curves(map, view.ridge, x, y, width, height),
    svg("g", { class: "words" }, boxes.map((box) => box.words)), axes(map, x, y, width, height));
  fill(place, picture);
  steer(picture, boxes, view, map);
  if (focused) picture.querySelector(`[data-cell="${focused}"]`)?.focus();
}

function patterns() {
  return svg("defs", {},
    svg("pattern", { id: "hatch", width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" }, svg("path", { d: "M0 0V6", class: "hatch-line" })),
    svg("pattern", { id: "rule", width: 6, height: 5, patternUnits: "userSpaceOnUse" }, svg("path", { d: "M0 2.5H6", class: "hatch-line" })));
}

function is_light(colour) {
  const [r, g, b] = [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16) / 255);
  return 0.299 * r + 0.587 * g + 0.114 * b > 0.56;
}

function one_cell(box, { map, quantity, progress, selected }) {
  const { cell } = box, w = box.right - box.left, h = box.bottom - box.top;
  const cx = (box.left + box.right) / 2, cy = (box.top + box.bottom) / 2;
  if (!cell) return svg("circle", { class: "missing", cx, cy, r: 1.5 });
  const frame = { x: box.left + 0.5, y: box.top + 0.5, width: Math.max(1, w - 1), height: Math.max(1, h - 1) };
  const colour = cell.colours?.[quantity];
  // Above the curves, with a rim of the cell's colour.
  const text = (words, kind = "", stroke = "none") => { if (w > 9 * words.length - 6 && h > 13) box.words = svg("text", { x: cx, y: cy + 4, class: `in-cell ${kind}`, stroke }, words); };
  const parts = [];
  if (cell.results) {
    parts.push(svg("rect", { ...frame, class: "value", fill: colour ?? "transparent" }));
    if (cell.stale) parts.push(svg("rect", { ...frame, fill: "url(#rule)" }));
    if (cell.unsettled) parts.push(svg("rect", { ...frame, fill: "url(#hatch)" }));
    if (cell.smaller_eer) parts.push(svg("path", { class: "corner", d: `M${box.right - 0.5} ${box.top + 0.5}v${Math.min(10, h / 2)}l${-Math.min(10, h / 2)} ${-Math.min(10, h / 2)}z` }));
    const letter = map.classes.find((c) => c.name === cell.class)?.letter;
    text(quantity === "class" ? letter : cell.words?.[quantity] ?? "–", !colour || is_light(colour) ? "on-light" : "on-dark", colour);
  } else if (cell.state === "failed") {
    parts.push(svg("rect", { ...frame, class: "failed" }), svg("path", { class: "cross", d: `M${cx - 5} ${cy - 5}l10 10m0 -10l-10 10` }));
  } else if (cell.state === "cancelled") {
    parts.push(svg("rect", { ...frame, class: "cancelled" }), svg("path", { class: "dash", d: `M${cx - 5} ${cy}h10` }));
  } else if (cell.state === "pending") {
    parts.push(svg("rect", { ...frame, class: "pending" }), svg("circle", { class: "ring", cx, cy, r: Math.min(3.5, w / 4, h / 4) }));
  }
  if (cell.running.length) {
    const part = Math.max(0, ...cell.running.map((hash) => progress[hash]?.part ?? 0));
    if (!cell.results) parts.push(svg("rect", { ...frame, class: "at-work" }), svg("rect", { ...frame, class: "progress", y: frame.y + frame.height * (1 - part), height: frame.height * part }));
    if (!cell.results) text(percent(part), "at-work-text");
    parts.push(svg("rect", { ...frame, x: frame.x + 1, y: frame.y + 1, width: Math.max(1, w - 3), height: Math.max(1, h - 3), class: "at-work-frame" }));
  }
  return svg("g", { class: `cell is-${cell.state}${selected === box.key ? " selected" : ""}`, "data-cell": box.key, "data-state": cell.state, role: "gridcell", tabindex: -1,
    "aria-label": `${digits(cell.v)} cm/s, ${digits(cell.theta)} degrees: ${cell.state}${cell.results ? `, ${cell.class}, b/a ${digits(cell.b_over_a[0], 3)}` : ""}` },
  parts, svg("rect", { ...frame, class: "focus" }));
}

/// The borders between cells whose largest remnant is an EER, in half of the runs and more, and all
/// others.
function outlined(boxes, map) {
  const d = outline(boxes, map);
  return [svg("path", { class: "eer-halo", d }), svg("path", { class: "eer-outline", d })];
}

function outline(boxes, map) {
  const n = map.v.at.length;
  const is_eer = (i, j) => i >= 0 && i < n && j >= 0 && j < map.theta.at.length && boxes[i + j * n].cell?.is_eer === true;
  let path = "";
  for (const { i, j, left, right, top, bottom } of boxes) {
    if (!is_eer(i, j)) continue;
    if (!is_eer(i - 1, j)) path += `M${left} ${top}V${bottom}`;
    if (!is_eer(i + 1, j)) path += `M${right} ${top}V${bottom}`;
    if (!is_eer(i, j + 1)) path += `M${left} ${top}H${right}`;
    if (!is_eer(i, j - 1)) path += `M${left} ${bottom}H${right}`;
  }
  return path;
}

/// Where v sin(theta) = s.
function curve(s, x, y) {
  const [low, high] = x.domain();
  return d3.range(121).map((k) => low + (k / 120) * (high - low)).filter((v) => v > s)
    .map((v) => [x(v), y((Math.asin(s / v) * 180) / Math.PI)]);
}

const path_of = d3.svg.line();

function curves(map, ridge, x, y, width, height) {
  const fitted = ridge && ridge.settings === map.settings && ridge.constant;
  const band = fitted && [...curve(ridge.low, x, y), ...curve(ridge.high, x, y).reverse()];
  return svg("g", { "clip-path": "url(#frame)" },
    svg("clipPath", { id: "frame" }, svg("rect", { x: margin.left, y: margin.top, width: width - margin.left - margin.right, height: height - margin.top - margin.bottom })),
    band && band.length > 0 && svg("path", { class: "band", d: `${path_of(band)}Z` }),
    fitted && [svg("path", { class: "halo", d: path_of(curve(ridge.constant, x, y)) }), svg("path", { class: "fitted", d: path_of(curve(ridge.constant, x, y)) })],
    map.paper_cm_per_s && [svg("path", { class: "halo", d: path_of(curve(map.paper_cm_per_s, x, y)) }), svg("path", { class: "paper", d: path_of(curve(map.paper_cm_per_s, x, y)) })]);
}

/// Places of the cells themselves, where there is room for their numbers, else round numbers.
const places = (at, scale, most) => (at.length <= most ? at : scale.ticks(most));

function axes(map, x, y, width, height) {
  const right = width - margin.right, bottom = height - margin.bottom, middle = (margin.left + right) / 2;
  const over = d3.scale.linear().domain(x.domain().map((v) => v / map.v_esc_cm_per_s)).range(x.range());
  const text = (value) => digits(value);
  return svg("g", { class: "axes" },
    svg("rect", { class: "frame", x: margin.left, y: margin.top, width: right - margin.left, height: bottom - margin.top }),
    axis(x, "bottom", [0, bottom], { values: places(map.v.at, x, Math.floor((right - margin.left) / 42)), text }),
    axis(y, "left", [margin.left, 0], { values: places(map.theta.at, y, Math.floor((bottom - margin.top) / 22)), text }),
    axis(over, "top", [0, margin.top], { count: Math.floor((right - margin.left) / 80), text, tick: 4, padding: 4 }),
    svg("text", { class: "title", x: middle, y: height - 8, "text-anchor": "middle" }, "impact speed, cm/s"),
    svg("text", { class: "title", x: middle, y: 14, "text-anchor": "middle" }, "impact speed over escape speed"),
    svg("text", { class: "title", "text-anchor": "middle", transform: `translate(12 ${(margin.top + bottom) / 2}) rotate(-90)` }, "impact angle, deg"));
}

/// Hover, click, and the arrow keys from cell to cell.
function steer(picture, boxes, view, map) {
  const group_of = (target) => target.closest?.("[data-cell]");
  const box_of = (group) => boxes.find((b) => b.key === group.dataset.cell);
  const groups = [...picture.querySelectorAll("[data-cell]")];
  (groups.find((g) => g.classList.contains("selected")) ?? groups[0])?.setAttribute("tabindex", 0);
  const hover = (group) => view.show_hover(group ? box_of(group).cell : null, group?.getBoundingClientRect());
  picture.addEventListener("pointerover", (event) => hover(group_of(event.target)));
  picture.addEventListener("pointerleave", () => hover(null));
  picture.addEventListener("focusin", (event) => hover(group_of(event.target)));
  picture.addEventListener("focusout", () => hover(null));
  picture.addEventListener("click", (event) => { const group = group_of(event.target); if (group) view.open(box_of(group).cell); });
  picture.addEventListener("keydown", (event) => {
    const group = group_of(event.target);
    if (!group) return;
    if (event.key === "Enter" || event.key === " ") return void (event.preventDefault(), view.open(box_of(group).cell));
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!step) return;
    event.preventDefault();
    const box = box_of(group), n = map.v.at.length;
    for (let i = box.i + step[0], j = box.j + step[1]; i >= 0 && i < n && j >= 0 && j < map.theta.at.length; i += step[0], j += step[1]) {
      const next = picture.querySelector(`[data-cell="${boxes[i + j * n].key}"]`);
      if (!next) continue;
      group.setAttribute("tabindex", -1);
      next.setAttribute("tabindex", 0);
      return void next.focus();
    }
  });
}
