// A log that goes on while the job does.

import { get } from "./api.js";
import { el } from "./dom.js";
import { gently, listen } from "./events.js";

export function live_log(address, is_running, signal) {
  const text = el("pre", { class: "log", tabindex: 0, "aria-label": "Log" });
  let from = 0;
  const more = async () => {
    const piece = await get(`${address}/log`, { from }, signal);
    if (piece.next < from) text.textContent = "";
    const at_end = text.scrollTop + text.clientHeight >= text.scrollHeight - 4;
    if (piece.text) text.append(piece.text);
    from = piece.next;
    if (at_end) text.scrollTop = text.scrollHeight;
    if (!text.textContent) text.dataset.empty = "no log yet";
    else delete text.dataset.empty;
  };
  more().catch(() => {});
  const again = gently(() => more().catch(() => {}), 1500);
  listen((kind) => (kind === "progress" || kind === "database") && is_running() && again(), signal);
  return el("section", { class: "card" }, el("h2", {}, "Log"), text);
}
