// Elements made without a text ever becoming markup.

/** An element with attributes and children, which are elements or texts. */
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'class') made.className = value;
    else made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

/** An SVG element. */
export function shape(name, attributes = {}) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

/** A name of the chart's in a direction of its own. */
export function bdi(text, kind) {
  return element('bdi', kind ? { class: kind } : {}, text);
}

/** Writes a text only where it is another one. */
export function write(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

/** Sets an attribute only where it is another one. */
export function mark(target, name, value) {
  if (target.getAttribute(name) !== value) target.setAttribute(name, value);
}

/** The element of an id. */
export function byId(id) {
  return document.getElementById(id);
}

/** The elements of a data attribute, by its value; several may share one. */
export function gather(root, attribute) {
  const found = new Map();
  for (const one of root.querySelectorAll(`[${attribute}]`)) {
    const value = one.getAttribute(attribute);
    if (found.has(value)) found.get(value).push(one);
    else found.set(value, [one]);
  }
  return found;
}
