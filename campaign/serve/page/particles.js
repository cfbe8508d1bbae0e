// Snapshots as the server packs them (campaign/serve/particles.hpp), and colours of their particles.

import { get_bytes } from "./api.js";

/// {head, x (3 n), depth, speed, pressure, body, remnant}
export function unpack(buffer) {
  const bytes = new DataView(buffer);
  if (bytes.getUint32(0) !== 0x65657231) throw new Error("this is no snapshot");
  const length = bytes.getUint32(4, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, length)));
  let at = 8 + length;
  const floats = (count) => { const part = new Float32Array(buffer, at, count); at += 4 * count; return part; };
  const octets = (count) => { const part = new Uint8Array(buffer, at, count); at += count; return part; };
  const n = head.n;
  return { head, x: floats(3 * n), depth: floats(n), speed: floats(n), pressure: floats(n), body: octets(n), remnant: octets(n) };
}

/// Snapshots of a job, each fetched once, the newest used kept.
export class Snapshots {
  constructor(hash, list, signal) {
    Object.assign(this, { hash, list, signal, kept: new Map() });
  }
  get(index) {
    const name = this.list[index].name;
    if (!this.kept.has(name)) {
      if (this.kept.size > 60) this.kept.delete(this.kept.keys().next().value);
      const pending = get_bytes(`job/${this.hash}/particles`, { snapshot: name }, this.signal).then(unpack);
      pending.catch(() => this.kept.delete(name));
      this.kept.set(name, pending);
    }
    return this.kept.get(name);
  }
}

const rgb = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));
// Okabe & Ito: told apart in every common form of colour blindness. Debris is grey.
const ranks = ["#8a8f98", "#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442"].map(rgb);

export const colourings = [["body", "body of origin"], ["depth", "depth of origin"], ["speed", "speed within its clump"], ["pressure", "pressure"], ["remnant", "remnant"]];

export const units = { depth: "m", speed: "m/s", pressure: "Pa" };

/// RGBA of every particle, a byte each; `range`: of the values, the same for all snapshots.
export function colours_of(snapshot, by, range) {
  const n = snapshot.head.n, out = new Uint8Array(4 * n);
  const put = (i, [r, g, b]) => { out[4 * i] = r; out[4 * i + 1] = g; out[4 * i + 2] = b; out[4 * i + 3] = 255; };
  if (by === "body") {
    const of_body = snapshot.head.colours.bodies.map(rgb);
    for (let i = 0; i < n; ++i) put(i, of_body[snapshot.body[i]]);
  } else if (by === "remnant") {
    for (let i = 0; i < n; ++i) put(i, ranks[snapshot.remnant[i] === 0 ? 0 : 1 + ((snapshot.remnant[i] - 1) % (ranks.length - 1))]);
  } else {
    const stops = snapshot.head.colours.stops.map(rgb), values = snapshot[by], [low, high] = range;
    const scale = (stops.length - 1) / (high - low || 1);
    for (let i = 0; i < n; ++i) put(i, stops[Math.min(stops.length - 1, Math.max(0, Math.round((values[i] - low) * scale)))]);
  }
  return out;
}

export const rank_colour = (rank) => `rgb(${ranks[rank === 0 ? 0 : 1 + ((rank - 1) % (ranks.length - 1))].join(" ")})`;
