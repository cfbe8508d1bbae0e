// What the server says, and what it is asked to do.

const key = "eerie-token";

/// The token stands behind # once; from then on this tab keeps it.
export function take_token() {
  const found = /^#token=([0-9a-f]+)$/.exec(location.hash);
  if (!found) return;
  sessionStorage.setItem(key, found[1]);
  history.replaceState(null, "", location.pathname + location.search);
}

export const has_token = () => sessionStorage.getItem(key) !== null;

async function said(response) {
  const text = await response.text();
  let answer = null;
  try {
    answer = JSON.parse(text);
  } catch {
    answer = { error: text || response.statusText };
  }
  if (!response.ok) throw new Error(answer.error ?? response.statusText);
  return answer;
}

export function query_of(parameters) {
  const query = new URLSearchParams();
  for (const [name, value] of Object.entries(parameters))
    for (const one of [value].flat())
      if (one !== null && one !== undefined && one !== "") query.append(name, one);
  const text = query.toString();
  return text ? `?${text}` : "";
}

export async function get(address, parameters = {}, signal = undefined) {
  return said(await fetch(`/api/${address}${query_of(parameters)}`, { signal }));
}

export async function get_bytes(address, parameters, signal) {
  const response = await fetch(`/api/${address}${query_of(parameters)}`, { signal });
  if (!response.ok) return said(response);
  return response.arrayBuffer();
}

/// An action, as campaign/request.hpp has it. Gives the answer; throws what is said against it.
export async function act(action) {
  const response = await fetch("/api/requests", {
    method: "POST",
    headers: { "Content-Type": "application/json", "X-Eerie-Token": sessionStorage.getItem(key) ?? "" },
    body: JSON.stringify(action),
  });
  return said(response);
}
