// A sweep from the page to the campaign.

import { ask } from "./actions.js";
import { el } from "./dom.js";

export function submit_form() {
  const text = el("textarea", { rows: 8, spellcheck: "false", "aria-label": "Sweep as JSON", placeholder: '{ "name": "my-sweep", "grid": { "v_imp_cm_per_s": [15, 20], "theta_imp_deg": [10, 15] } }' });
  const file = el("input", { type: "file", accept: ".json,application/json", "aria-label": "Sweep file", onchange: async () => { text.value = await file.files[0].text(); } });
  const priority = el("input", { type: "number", value: 0, step: 1, class: "short", "aria-label": "Priority" });
  const send = async () => {
    const action = { kind: "submit", sweep: text.value };
    if (priority.value && priority.value !== "0") action.priority = Number(priority.value);
    if (await ask(action)) text.value = "";
  };
  return el("details", { class: "card submit" }, el("summary", {}, el("h2", {}, "Submit a sweep")),
    el("div", { class: "form" }, file, text, el("div", { class: "row" }, el("label", { class: "field" }, el("span", {}, "priority"), priority),
      el("button", { type: "button", class: "main", "data-action": "submit", onclick: send }, "Submit"))));
}
