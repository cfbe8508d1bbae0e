// Buttons that ask something of the campaign. Without the token there are none.

import { act, has_token } from "./api.js";
import { el, fill } from "./dom.js";

const past = {
  pause: "paused", resume: "resumed", cancel: "cancelled", retry: "will be tried again",
  "rerun-stale": "will run again", priority: "have a new priority",
};

let clearing = 0;
export function toast(text, is_problem = false) {
  const place = document.getElementById("toast");
  place.classList.toggle("problem", is_problem);
  fill(place, text);
  clearTimeout(clearing);
  clearing = setTimeout(() => fill(place), 8000);
}

export function told(action, answer) {
  if (answer.waits) return `Noted: ${answer.waits}`;
  if (action.kind === "submit") return `${answer.sweep}: ${answer.jobs} jobs, ${answer.added} new`;
  return `${answer.jobs} job${answer.jobs === 1 ? "" : "s"} ${past[action.kind]}`;
}

export async function ask(action) {
  try {
    toast(told(action, await act(action)));
    return true;
  } catch (problem) {
    toast(problem.message, true);
    return false;
  }
}

export const may_act = () => has_token() && document.body.dataset.readOnly !== "true";

/// Buttons for a selection of jobs; `states`: what the jobs are, where that is known.
export function action_bar(selection, states = {}) {
  if (!may_act())
    return el("p", { class: "hint" }, document.body.dataset.readOnly === "true"
      ? "Started with --read-only."
      : "To pause, resume, cancel or retry, open the address that eerie serve printed.");
  const button = (kind, text, shown = true) =>
    shown && el("button", { type: "button", "data-action": kind, onclick: () => ask({ kind, ...selection }) }, text);
  const ask_priority = () => {
    const text = prompt("Priority: higher ones come first; 0 is usual", "0");
    if (text === null) return;
    if (!/^-?\d{1,9}$/.test(text.trim())) return void toast("A priority is a whole number.", true);
    ask({ kind: "priority", priority: Number(text), ...selection });
  };
  const open = states.pending !== false || states.running !== false;
  return el("div", { class: "actions" },
    button("pause", "Pause", open && !states.paused), button("resume", "Resume", open && states.paused !== false),
    button("retry", "Retry", states.failed !== false), button("rerun-stale", "Rerun stale", states.stale === true),
    open && el("button", { type: "button", "data-action": "priority", onclick: ask_priority }, "Priority…"),
    button("cancel", "Cancel", open));
}
