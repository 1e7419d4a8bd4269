// Elements from code; texts are always set as text, never as HTML.

export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(key, value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

export function option(value, text, selected) {
  return element("option", { value, selected }, text);
}

/** A labelled <select>; `choices` are [value, text], `pick` gets the value. */
export function select(label, id, choices, current, pick) {
  const list = element("select", { id, onchange: () => pick(list.value) },
                       ...choices.map(([value, text]) => option(value, text, value === current)));
  return element("label", { class: "choice" }, `${label} `, list);
}

export function escaped(text) {
  return String(text).replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);
}
