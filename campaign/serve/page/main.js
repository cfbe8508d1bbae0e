// Addresses to views; links and the browser's back and forward stay in the page.

import { get, take_token } from "./api.js";
import { el, fill } from "./dom.js";
import { listen } from "./events.js";
import { short } from "./format.js";
import { show_campaign } from "./campaign.js";
import { show_compare } from "./compare.js";
import { show_job } from "./job.js";
import { show_jobs } from "./jobs.js";
import { show_map } from "./map.js";

const view = document.getElementById("view");
let present = null;
let failed = false;

const views = [
  [/^\/(campaign)?$/, "Campaign", show_campaign],
  [/^\/map$/, "Map", show_map],
  [/^\/jobs$/, "Jobs", show_jobs],
  [/^\/job\/([0-9a-f]+)$/, "Job", show_job],
  [/^\/compare$/, "Compare", show_compare],
];

/// Goes to an address; `replace`: the way back does not lead to this one.
export function go(address, replace = false) {
  history[replace ? "replaceState" : "pushState"](null, "", address);
  show();
}

/// Notes the choices of a view in its address.
export function note(parameters) {
  const query = new URLSearchParams();
  for (const [name, value] of Object.entries(parameters))
    for (const one of [value].flat()) if (one !== null && one !== undefined && one !== "") query.append(name, one);
  const text = query.toString();
  history.replaceState(null, "", location.pathname + (text ? `?${text}` : ""));
}

async function show() {
  present?.abort();
  failed = false;
  const here = (present = new AbortController());
  const match = views.map(([pattern, title, body]) => [pattern.exec(location.pathname), title, body])
    .find(([found]) => found);
  for (const link of document.querySelectorAll("header nav a"))
    link.toggleAttribute("aria-current", location.pathname.startsWith(link.pathname) ||
      (link.pathname === "/campaign" && location.pathname === "/") ||
      (link.pathname === "/jobs" && location.pathname.startsWith("/job/")));
  if (!match) return void fill(view, el("p", { class: "empty" }, "There is nothing at this address."));
  const [found, title, body] = match;
  document.title = `${title}${found[1] && title === "Job" ? ` ${short(found[1])}` : ""} · eerie`;
  try {
    await body(view, { signal: here.signal, query: new URLSearchParams(location.search), word: found[1], go, note });
    if (!here.signal.aborted) view.dataset.ready = location.pathname;
  } catch (problem) {
    if (here.signal.aborted) return;
    failed = true;
    fill(view, el("p", { class: "empty" }, problem.message));
  }
}

document.addEventListener("click", (event) => {
  const link = event.target.closest("a[href]");
  if (!link || event.defaultPrevented || event.button !== 0 || event.ctrlKey || event.metaKey || event.shiftKey) return;
  if (link.origin !== location.origin || link.hasAttribute("download") || link.pathname.startsWith("/api/")) return;
  if (link.getAttribute("href").startsWith("#")) return;
  event.preventDefault();
  go(link.href);
  scrollTo(0, 0);
});
addEventListener("popstate", show);

function show_pulse(kind, data) {
  const pulse = document.getElementById("pulse");
  const banner = document.getElementById("banner");
  if (kind === "connection" && !data) {
    pulse.dataset.state = "lost";
    fill(pulse, "not connected");
  }
  if (kind === "work" || (kind === "connection" && data)) {
    const works = kind === "work" ? data.worked_on_by : pulse.dataset.holder;
    pulse.dataset.holder = works ?? "";
    pulse.dataset.state = works ? "live" : "still";
    pulse.title = works ? `worked on by ${works}` : "nobody works on this database";
    fill(pulse, works ? "live" : "at rest");
  }
  if (kind === "database") {
    banner.hidden = !data.problem;
    fill(banner, data.problem ?? "");
    // A view that found no database is shown once there is one.
    if (failed && !data.problem) show();
  }
}

take_token();
listen(show_pulse, new AbortController().signal);
get("about").then((about) => {
  const name = document.getElementById("database");
  name.title = about.path;
  fill(name, about.database);
  document.body.dataset.readOnly = about.read_only;
});
show();
