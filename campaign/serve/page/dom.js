// Elements by name, attributes and children. Text is always text, never HTML.

function append(node, children) {
  for (const child of children.flat(Infinity))
    if (child !== null && child !== undefined && child !== false)
      node.append(child instanceof Node ? child : String(child));
  return node;
}

function assign(node, properties) {
  for (const [name, value] of Object.entries(properties)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else node.setAttribute(name, value === true ? "" : value);
  }
  return node;
}

export function el(name, properties = {}, ...children) {
  return append(assign(document.createElement(name), properties), children);
}

export function svg(name, properties = {}, ...children) {
  return append(assign(document.createElementNS("http://www.w3.org/2000/svg", name), properties), children);
}

/// Puts new children into a node, and leaves it alone where nothing would change.
export function fill(node, ...children) {
  node.replaceChildren();
  return append(node, children);
}

/// A choice: options are [value, text].
export function select(label, options, value, onchange) {
  const list = el("select", { onchange: () => onchange(list.value) },
    options.map(([v, text]) => el("option", { value: v, selected: String(v) === String(value) }, text)));
  return el("label", { class: "field" }, el("span", {}, label), list);
}
