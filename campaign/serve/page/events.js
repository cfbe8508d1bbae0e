// What changes, told by the server: "database", "work" and "progress". Views listen while they are
// there; a listener hears at once what was told last.

import { get } from "./api.js";

const listeners = new Set();
const last = new Map();
let source = null;
let poll = 0;

function tell(kind, data) {
  last.set(kind, data);
  for (const listener of listeners) listener(kind, data);
}

function connect() {
  source?.close();
  clearTimeout(poll);
  source = null;
  if (document.hidden) return;
  source = new EventSource("/api/events");
  for (const kind of ["database", "work", "progress"])
    source.addEventListener(kind, (event) => tell(kind, JSON.parse(event.data)));
  source.onopen = () => tell("connection", true);
  source.onerror = () => {
    // A browser tries again by itself unless it was refused, as where too many listen.
    if (source?.readyState === EventSource.CLOSED) ask();
    else tell("connection", false);
  };
}

/// Where there is no room to listen: asks for the news, and tries again when the server says.
async function ask() {
  let again_s = 5;
  try {
    const news = await get("news");
    ({ again_s } = news);
    tell("connection", true);
    for (const kind of ["database", "work", "progress"])
      if (news[kind] && JSON.stringify(news[kind]) !== JSON.stringify(last.get(kind))) tell(kind, news[kind]);
  } catch {
    tell("connection", false);
  }
  clearTimeout(poll);
  poll = setTimeout(connect, 1000 * again_s);
}

// A browser has six connections to a server, for all its tabs and for the pages that it keeps for
// the way back. Seven that listen would stop each other: only those that somebody sees do.
document.addEventListener("visibilitychange", connect);

export function listen(listener, signal) {
  if (!source && !document.hidden) connect();
  listeners.add(listener);
  signal.addEventListener("abort", () => listeners.delete(listener));
  for (const [kind, data] of last) listener(kind, data);
}

/// Calls `body` now and then: at once, then no sooner than so many ms after the last time, and only
/// while somebody looks at the page.
export function gently(body, pause = 1000) {
  let waiting = false;
  let next = 0;
  return () => {
    if (waiting) return;
    waiting = true;
    const run = () => {
      if (document.hidden) return void document.addEventListener("visibilitychange", run, { once: true });
      waiting = false;
      next = Date.now() + pause;
      body();
    };
    setTimeout(run, Math.max(0, next - Date.now()));
  };
}
