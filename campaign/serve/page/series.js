// The history of a run as charts.

import { el } from "./dom.js";
import { line_chart } from "./chart.js";

const panels = [
  { title: "shape of the largest remnant", low: 0, high: 1, marks: [{ y: 0.3 }], lines: [["b_over_a", "b/a"], ["c_over_a", "c/a"]] },
  { title: "mass", unit: "over all mass", low: 0, high: 1, lines: [["m_1_over_m_total", "largest"], ["m_2_over_m_total", "second"]] },
  { title: "energy", unit: "J", lines: [["kinetic_energy_J", "kinetic"], ["potential_energy_J", "potential"], ["internal_energy_J", "internal"]] },
  { title: "change of angular momentum", unit: "|ΔL| / L", lines: [["dL_over_L", "ΔL/L"]] },
];

export function series(columns) {
  const t = columns.time_s ?? [];
  const node = el("div", { class: "series" });
  if (t.length < 2) {
    node.append(el("p", { class: "empty" }, "The history has no rows yet."));
    node.point_at = () => {};
    return node;
  }
  const charts = panels.map((panel) => line_chart(panel.lines.filter(([name], k) => k === 0 || columns[name]?.some((v) => v !== 0))
    .map(([name, title], k) => ({ name: title, x: t, y: columns[name], kind: k + 1 })), panel));
  node.append(...charts, el("p", { class: "axis-name" }, "time, s"));
  node.point_at = (time) => charts.forEach((c) => c.point_at(time));
  return node;
}
