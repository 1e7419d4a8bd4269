// Pieces of SVG, and saving one as a file.

import { element } from "./dom.js";

export function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes))
    if (value !== null && value !== undefined) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

export function text(x, y, words, attributes = {}) {
  const made = svg("text", { x, y, ...attributes });
  made.textContent = words;
  return made;
}

/** Words broken into lines of at most `letters`. */
export function lines(words, letters) {
  const out = [""];
  for (const word of words.split(" ")) {
    if (out.at(-1) && (out.at(-1) + word).length > letters) out.push("");
    out[out.length - 1] += (out.at(-1) ? " " : "") + word;
  }
  return out;
}

/** A button that saves the drawing that `current` returns. */
export function saveButton(name, current) {
  return element("button", {
    type: "button", class: "save",
    onclick: () => {
      const file = `<?xml version="1.0" encoding="UTF-8"?>\n${
        new XMLSerializer().serializeToString(current())}\n`;
      const url = URL.createObjectURL(new Blob([file], { type: "image/svg+xml" }));
      element("a", { href: url, download: `${name()}.svg` }).click();
      setTimeout(() => URL.revokeObjectURL(url), 1000);
    },
  }, "Save as SVG");
}
