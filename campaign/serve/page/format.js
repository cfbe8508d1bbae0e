// Numbers and times as people read them.

export const none = "–";

export function fixed(value, digits = 2) {
  return Number.isFinite(value) ? value.toFixed(digits) : none;
}

/// So many significant digits, without trailing zeros.
export function digits(value, count = 4) {
  if (!Number.isFinite(value)) return none;
  const magnitude = Math.abs(value);
  if (magnitude !== 0 && (magnitude >= 1e7 || magnitude < 1e-4))
    return value.toExponential(Math.max(0, count - 2)).replace("e+", "e");
  return String(Number(value.toPrecision(count)));
}

/// 1,234,567
export const whole = (value) => (Number.isFinite(value) ? value.toLocaleString("en-US") : none);

/// 1.2 M
export function magnitude(value) {
  if (!Number.isFinite(value)) return none;
  for (const [size, letter] of [[1e12, "T"], [1e9, "G"], [1e6, "M"], [1e3, "k"]])
    if (Math.abs(value) >= size) return `${(value / size).toPrecision(3)} ${letter}`;
  return digits(value, 3);
}

export function duration(seconds) {
  if (!Number.isFinite(seconds) || seconds < 0) return none;
  if (seconds < 60) return `${Math.round(seconds)} s`;
  if (seconds < 3600) return `${Math.round(seconds / 60)} min`;
  if (seconds < 86400 * 2) return `${(seconds / 3600).toFixed(1)} h`;
  return `${(seconds / 86400).toFixed(1)} d`;
}

export const short = (hash) => hash.slice(0, 8);
export const percent = (part) => `${Math.round(100 * part)} %`;

/// 2026-11-29T03:46:06.804Z -> 2026-11-29 03:46:06
export const moment = (iso) => (iso ? iso.slice(0, 19).replace("T", " ") : none);

/// A cell of a table, by the kind of the value.
export function cell(value, name = "") {
  if (value === null || value === undefined) return none;
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value !== "number") return name === "hash" ? short(value) : String(value);
  if (name === "wall_s") return duration(value);
  return Number.isInteger(value) ? String(value) : digits(value, 4);
}
