// What happened, as a picture: particles of a job in 3D over its snapshots.

import { el, fill, select } from "./dom.js";
import { digits, whole } from "./format.js";
import { Points } from "./points.js";
import { Snapshots, colourings, colours_of, rank_colour, units } from "./particles.js";

/// How far things reach about `centre`: the remnants with their longest axes, or all particles;
/// no farther than three times both bodies at the start.
function reach(snapshot, centre) {
  const far = (x, more = 0) => Math.hypot(...x.map((v, k) => v - centre[k])) + more;
  const { remnants } = snapshot.head;
  if (remnants.length) return Math.max(...remnants.map((r) => far(r.x, 0.6 * r.lengths[0])));
  let most = 1;
  for (let i = 0; i < snapshot.x.length; i += 3) most = Math.max(most, far(snapshot.x.slice(i, i + 3)));
  return most;
}

function widest(values) {
  return [Math.min(...values.map((v) => v[0])), Math.max(...values.map((v) => v[1]))];
}

function scale_key(snapshot, by, range) {
  if (by === "body") return el("p", { class: "keys row" }, ["target", "impactor"].map((name, k) => el("span", {}, dot(snapshot.head.colours.bodies[k]), name)));
  if (by === "remnant") return el("p", { class: "keys row" }, snapshot.head.remnants.slice(0, 6).map((r) => el("span", {}, dot(rank_colour(r.rank)), `${r.rank}`)), el("span", {}, dot(rank_colour(0)), "debris"));
  const bar = el("span", { class: "ramp" });
  bar.style.setProperty("background", `linear-gradient(to right, ${snapshot.head.colours.stops.join(",")})`);
  return el("p", { class: "keys row" }, digits(range[0], 2), bar, `${digits(range[1], 2)} ${units[by]}`);
}

function dot(colour) {
  const node = el("i", { class: "dot" });
  node.style.setProperty("background", colour);
  return node;
}

/// A viewer of a job's snapshots. Options: small (without its tools), on_time(t). Gives the node,
/// with .add(list) for snapshots that are new.
export function viewer(hash, list, signal, { small = false, on_time = () => {} } = {}) {
  if (list.length === 0) return el("p", { class: "empty" }, "No snapshot yet: the first comes when the run starts.");
  const canvas = el("canvas", { tabindex: 0, role: "img", "aria-label": "Particles in three dimensions: turn with the mouse or the arrow keys, zoom with the wheel or + and -" });
  let points = null;
  try {
    points = new Points(canvas, signal);
  } catch (problem) {
    return el("p", { class: "empty" }, problem.message);
  }
  const snapshots = new Snapshots(hash, list, signal);
  const node = el("div", { class: `viewer${small ? " small" : ""}` });
  let index = list.length - 1, by = "body", remnant = 1, playing = false, present = null, framed = false;
  const ranges = {};
  const caption = el("p", { class: "caption" }), key = el("div", {}), time = el("output", {}), choice = el("span", {});
  const slider = el("input", { type: "range", min: 0, max: list.length - 1, value: index, "aria-label": "Time", oninput: () => show(Number(slider.value)) });
  const play = el("button", { type: "button", class: "play", onclick: () => { playing = !playing; run(); } }, "▶ Play");

  const range_of = (snapshot) => {
    if (!units[by]) return null;
    ranges[by] = widest([...(ranges[by] ? [ranges[by]] : []), snapshot.head.ranges[by]]);
    return ranges[by];
  };
  const frame = (snapshot) => {
    const found = snapshot.head.remnants.find((r) => r.rank === remnant);
    const all = remnant === 0 || !found;
    const centre = all ? [0, 0, 0] : found.x;
    const bodies = 12 * Math.max(...(list.bodies ?? [0]), snapshot.head.radius_m * Math.cbrt(snapshot.head.of));
    points.look_at(centre, all ? Math.min(reach(snapshot, centre), bodies) : 0.75 * Math.max(found.lengths[0], 1));
  };
  const axes = (snapshot) => {
    const found = snapshot.head.remnants.find((r) => r.rank === Math.max(1, remnant));
    points.segments(found ? found.axes.map((axis, k) => ({ colour: [[213, 94, 0], [0, 158, 115], [86, 180, 233]][k],
      from: axis.map((a, i) => found.x[i] - 0.62 * found.lengths[k] * a), to: axis.map((a, i) => found.x[i] + 0.62 * found.lengths[k] * a) })) : []);
    fill(caption, found ? [`Remnant ${found.rank}: `, ["a", "b", "c"].map((n, k) => el("span", { class: `axis axis-${n}` }, `${n} ${digits(found.lengths[k], 3)} m `)), `b/a ${digits(found.lengths[1] / found.lengths[0], 3)}`] : "No remnant of 100 particles.",
      snapshot.head.n < snapshot.head.of && ` ${whole(snapshot.head.n)} of ${whole(snapshot.head.of)} particles are drawn.`);
  };
  const paint = () => {
    const range = range_of(present);
    points.colours(colours_of(present, by, range));
    fill(key, scale_key(present, by, range));
  };
  const choose_remnant = (snapshot) => fill(choice, select("about", [[0, "everything"], ...snapshot.head.remnants.slice(0, 12).map((r) => [r.rank, `remnant ${r.rank}`])], remnant, (value) => { remnant = Number(value); frame(present); axes(present); }));
  const show = async (k) => {
    index = k;
    slider.value = k;
    try {
      const snapshot = await snapshots.get(k);
      if (k !== index) return;
      present = snapshot;
      points.positions(snapshot.x, snapshot.head.radius_m);
      paint();
      if (!framed || !playing) frame(snapshot);
      framed = true;
      axes(snapshot);
      choose_remnant(snapshot);
      fill(time, `${digits(snapshot.head.time_s, 5)} s`);
      on_time(snapshot.head.time_s);
      canvas.dataset.shown = k;
    } catch (problem) {
      if (!signal.aborted) fill(caption, problem.message);
    }
    if (k + 1 < list.length && playing) snapshots.get(k + 1).catch(() => {});
  };
  const run = async () => {
    fill(play, playing ? "❚❚ Pause" : "▶ Play");
    if (playing && index === list.length - 1) index = -1;
    if (playing) { remnant = 0; framed = false; }
    while (playing && !signal.aborted && index < list.length - 1) {
      await Promise.all([show(index + 1), new Promise((done) => setTimeout(done, 160))]);
    }
    playing = false;
    fill(play, "▶ Play");
  };
  node.add = (more) => {
    const at_end = index === list.length - 1;
    list.splice(0, list.length, ...more);
    slider.max = list.length - 1;
    if (at_end && !playing) show(list.length - 1);
  };
  node.points = points;
  const times = el("div", { class: "row times" }, list.length > 1 && play, slider, time);
  const tools = el("div", { class: "row tools" }, select("colour", colourings, by, (value) => { by = value; if (present) paint(); }), choice, key);
  node.append(el("div", { class: "stage" }, canvas), times, !small ? tools : "", caption);
  show(index);
  return node;
}
