// One drawing of every chart: a figure is panels with axes and series of marks, a legend, a title and a
// caption, as harness/present/figure.h has it and writes it as JSON. What a figure leaves out has the
// value that it has there.

import { scaleLinear, scaleLog, symbol, symbolCircle } from "d3";
import { lines, svg, text } from "./svg.js";

const dashes = [null, "6,3", "8,3,2,3", "18,4", "3,4"];

/** A symbol with corners on a circle, the first at `turn` quarter turns from the right. */
function polygon(corners, turn) {
  return { draw(context, size) {
    const radius = Math.sqrt(2 * size / (corners * Math.sin(2 * Math.PI / corners)));
    for (let i = 0; i < corners; ++i) {
      const angle = Math.PI * (turn / 2 + 2 * i / corners);
      context[i ? "lineTo" : "moveTo"](radius * Math.cos(angle), radius * Math.sin(angle));
    }
    context.closePath();
  } };
}

const markers = [symbolCircle, polygon(4, 0.5), polygon(3, -1), polygon(4, 0), polygon(3, 1), polygon(5, -1)];

function marker(x, y, look, filled = true, size = 1) {
  return svg("path", { d: symbol(markers[look.marker ?? 0], 60 * size * size)(),
                       transform: `translate(${x},${y})`, fill: filled ? look.colour : "white",
                       stroke: filled ? "white" : look.colour, "stroke-width": filled ? 0.7 : 1.4 });
}

function stroke(d, look, width = 1) {
  return svg("path", { d, fill: "none", stroke: look.colour, "stroke-width": width,
                       "stroke-dasharray": dashes[look.dash ?? 0] });
}

/** The stroke and marker of a solver, as they stand in legends. */
export function key(x, y, { look, line = false, point = true, filled = true }) {
  return svg("g", { transform: `translate(${x},${y})` },
             ...(line ? [stroke("M0,0H26", look, 2)] : []),
             ...(point ? [marker(13, 0, look, filled)] : []));
}

/** Adds what is said to whoever hovers over it. */
function noted(element, note) {
  if (!note) return element;
  const title = svg("title");
  title.textContent = note;
  element.append(title);
  return element;
}

const number = (value) => typeof value === "number" && !Number.isNaN(value);
const anchors = { left: "start", centre: "middle", right: "end" };

/** Marks joined to a path; one without a place parts it. */
function path(marks, x, y) {
  let pen = "M";
  return marks.map((m) => {
    if (!number(m.x) || !number(m.y)) { pen = "M"; return ""; }
    const step = `${pen}${x(m.x).toFixed(2)},${y(m.y).toFixed(2)}`;
    pen = "L";
    return step;
  }).join("");
}

const drawers = {
  line: ({ marks, size = 1 }, x, y) =>
    (marks.length ? [noted(stroke(path(marks, x, y), marks[0].look, size), marks[0].text)] : []),
  points: ({ marks, size = 1 }, x, y) => marks.filter((m) => number(m.x) && number(m.y)).map((m) => {
    const bars = (number(m.x_low) ? `M${x(m.x_low)},${y(m.y)}H${x(m.x_high)}` : "")
      + (number(m.y_low) ? `M${x(m.x)},${y(m.y_low)}V${y(m.y_high)}` : "");
    return noted(svg("g", {}, ...(bars ? [stroke(bars, { colour: m.look.colour }, 1.4)] : []),
                     marker(x(m.x), y(m.y), m.look, m.filled, size)), m.text);
  }),
  boxes: ({ marks, opacity = 1 }, x, y) => marks.map((m) => {
    const [x1, x2] = [x(m.x_low), x(m.x_high)], [y1, y2] = [y(m.y_low), y(m.y_high)];
    return noted(svg("rect", { x: Math.min(x1, x2), y: Math.min(y1, y2), width: Math.abs(x2 - x1),
                               height: Math.abs(y2 - y1), fill: m.look.colour,
                               "fill-opacity": opacity }), m.text);
  }),
  area: ({ marks, opacity = 1 }, x, y) =>
    (marks.length ? [svg("path", { d: path(marks, x, y), fill: marks[0].look.colour,
                                   "fill-opacity": opacity })] : []),
  text: ({ marks, size = 1, align = "left" }, x, y) =>
    marks.filter((m) => number(m.x) && number(m.y) && m.text).map((m) =>
      text(x(m.x), y(m.y) + 4 * size, m.text, {
        fill: m.look.colour, "text-anchor": anchors[align], "font-size": 11.5 * size,
        stroke: "white", "stroke-width": 2.5, "stroke-opacity": 0.8, "paint-order": "stroke" })),
};

function axes({ x: across, y: up, area: [left, width, top, height] }, x, y) {
  const bottom = top + height, faint = { colour: "#e6e6e6" }, dark = { colour: "#555555" };
  const parts = [];
  for (const [at, label] of across.ticks ?? []) {
    if (across.grid !== false) parts.push(stroke(`M${x(at)},${top}V${bottom}`, faint, 0.8));
    parts.push(stroke(`M${x(at)},${bottom}v4`, dark),
               text(x(at), bottom + 16, label, { "text-anchor": "middle", "font-size": 11 }));
  }
  for (const [at, label] of up.ticks ?? []) {
    if (up.grid !== false) parts.push(stroke(`M${left},${y(at)}h${width}`, faint, 0.8));
    parts.push(stroke(`M${left},${y(at)}h-4`, dark),
               text(left - 7, y(at) + 4, label, { "text-anchor": "end", "font-size": 11 }));
  }
  const middle = top + height / 2;
  return [...parts, stroke(`M${left},${top}V${bottom}h${width}`, dark),
          text(left + width / 2, bottom + 34, across.label ?? "", { "text-anchor": "middle" }),
          text(14, middle, up.label ?? "", { "text-anchor": "middle",
                                             transform: `rotate(-90 ${14} ${middle})` })];
}

function drawPanel(panel) {
  const [left, width, top, height] = panel.area;
  const scale = ({ low, high, log }, from, to) =>
    (log ? scaleLog : scaleLinear)([low, high], [from, to]);
  const x = scale(panel.x, left, left + width), y = scale(panel.y, top + height, top);
  return svg("g", {}, ...(panel.axes === false ? [] : axes(panel, x, y)),
    text(left + width / 2, top - 10, panel.title ?? "", { "text-anchor": "middle", "font-size": 13 }),
    ...panel.series.flatMap((series) => drawers[series.kind](series, x, y)));
}

/** Entries from left to right, or down where the area is narrow. */
function drawLegend({ legend = [], legend_area: [left, width, top, height] = [0, 0, 0, 0] }) {
  if (height === 0) return [];
  let x = left, y = top + 10;
  return legend.flatMap((entry) => {
    const long = 52 + 6.4 * entry.name.length;
    if (x > left && (width < 400 || x + long > left + width)) { x = left; y += 17; }
    const parts = [key(x, y, entry), text(x + 32, y + 4, entry.name, { "font-size": 11.5 })];
    x += long;
    return parts;
  });
}

/** The figure as one SVG, which can stand alone as a file. */
export function drawFigure(figure) {
  const { title, caption = "", width, height } = figure;
  const below = lines(caption, width / 6);
  const tall = height + 12 + 16 * below.length;
  return svg("svg", {
    xmlns: "http://www.w3.org/2000/svg", width, height: tall, viewBox: `0 0 ${width} ${tall}`,
    role: "img", "aria-label": `${title}. ${caption}`, fill: "#1a1a1a", "font-size": 12,
    "font-family": "system-ui, 'Segoe UI', Helvetica, Arial, sans-serif" },
    svg("rect", { width, height: tall, fill: "white" }),
    text(0, 16, title, { "font-size": 15, "font-weight": 600 }),
    ...figure.panels.map(drawPanel), ...drawLegend(figure),
    ...below.map((words, i) => text(0, height + 14 + 16 * i, `${words} `, { fill: "#444" })));
}
