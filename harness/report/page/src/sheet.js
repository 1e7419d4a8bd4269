// One SVG made of several drawings, with its title: what is shown, and what is saved as a file.

import { element } from "./dom.js";

const namespace = "http://www.w3.org/2000/svg";
const font = "system-ui, 'Segoe UI', Helvetica, Arial, sans-serif";

export function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS(namespace, name);
  for (const [key, value] of Object.entries(attributes))
    if (value !== null && value !== undefined) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** What a plot drew, as a group that can stand anywhere on a sheet. */
export function placed(plot, x, y) {
  const drawn = plot.tagName === "svg" ? plot : plot.querySelector("svg");
  const group = svg("g", { transform: `translate(${x},${y})`, "font-size": 12 });
  for (const child of [...drawn.childNodes]) if (child.nodeName !== "style") group.append(child);
  return group;
}

export function text(x, y, words, attributes = {}) {
  const made = svg("text", { x, y, ...attributes });
  made.textContent = words;
  return made;
}

/** Words broken into lines of at most `letters`. */
function lines(words, letters) {
  const out = [""];
  for (const word of words.split(" ")) {
    if (out.at(-1) && (out.at(-1) + word).length > letters) out.push("");
    out[out.length - 1] += (out.at(-1) ? " " : "") + word;
  }
  return out;
}

const line = 16;

/** Height of the head of a sheet. */
export function headHeight(width, subtitle) {
  return 30 + line * lines(subtitle, width / 6.1).length;
}

export function sheet({ width, height, title, subtitle, parts }) {
  const root = svg("svg", {
    xmlns: namespace, width, height, viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": `${title}. ${subtitle}`, fill: "#1a1a1a", "font-family": font, "font-size": 12,
  });
  root.append(svg("rect", { width, height, fill: "white" }));
  root.append(text(0, 16, title, { "font-size": 15, "font-weight": 600 }));
  lines(subtitle, width / 6.1).forEach((each, i) =>
    root.append(text(0, 34 + line * i, each, { fill: "#444" })));
  root.append(...parts);
  return root;
}

/** A key for one solver: its dash, its symbol and its letter. */
export function key(x, y, mark, shape) {
  return svg("g", { transform: `translate(${x},${y})` },
    svg("line", { x1: 0, x2: 22, stroke: mark.colour, "stroke-width": 2,
                  "stroke-dasharray": mark.dash === "none" ? null : mark.dash }),
    svg("path", { d: shape, transform: "translate(11,0)", fill: mark.colour, stroke: "white",
                  "stroke-width": 0.5 }));
}

function file(root) {
  const copy = root.cloneNode(true);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy)}\n`;
}

/** A button that saves the drawing that `current` returns. */
export function saveButton(name, current) {
  return element("button", {
    type: "button", class: "save",
    onclick: () => {
      const url = URL.createObjectURL(new Blob([file(current())], { type: "image/svg+xml" }));
      element("a", { href: url, download: `${name()}.svg` }).click();
      setTimeout(() => URL.revokeObjectURL(url), 1000);
    },
  }, "Save as SVG");
}
