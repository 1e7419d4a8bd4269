// The plane: median time against median accuracy of each solver, with quartiles, the Pareto front, and
// at its edge what became of every instance of the corpus.

import * as Plot from "@observablehq/plot";
import { chartSection, numbersTable } from "./chart_section.js";
import { select } from "./dom.js";
import { counts } from "./judge.js";
import { duration, figure, logTicks, percent, power, tolerance } from "./numbers.js";
import { ascending, quantile } from "./quantile.js";
import { headHeight, placed, sheet, svg, text } from "./sheet.js";
import { shapeOf } from "./shapes.js";

const floor = 1e-18;  // Residuals below, 0 too, are drawn here.

const fates = [
  ["success", "solved", "#8fc9a8"],
  ["trivial", "trivial", "#d9efe2"],
  ["no_solution", "no solution", "#f0b84a"],
  ["cycle", "cycle or limit", "#f2e27a"],
  ["error", "error", "#dd7a4a"],
  ["unsupported", "unsupported", "#cfcfcf"],
  ["not_run", "not run", "#ffffff"],
];

function spread(values) {
  const sorted = ascending(values);
  return [0.25, 0.5, 0.75].map((p) => quantile(sorted, p));
}

function pointOf(variant, rows) {
  const mass = Object.fromEntries(fates.map(([fate]) => [fate, 0]));
  for (const each of rows) ++mass[each.column];
  const solved = rows.filter((each) => each.column === "success");
  const counted = rows.filter((each) => counts(each.column)).length;
  const point = { variant, mass, instances: rows.length, counted, solved: solved.length };
  const times = solved.map((each) => each.row.median_ns).filter((ns) => ns !== null);
  if (times.length === 0) return point;
  return {
    ...point,
    time: spread(times.map((ns) => ns * 1e-6)),
    residual: spread(solved.map((each) => each.row.accuracy.residual)),
  };
}

/** Points that no other beats in time and accuracy, by time. */
export function paretoFront(points) {
  const front = [];
  for (const point of [...points].sort((a, b) => a.time[1] - b.time[1] ||
                                                 a.residual[1] - b.residual[1]))
    if (front.length === 0 || point.residual[1] < front.at(-1).residual[1]) front.push(point);
  return front;
}

/** A place for each point's letter where it covers no other letter or point. */
function letterPlaces(spots) {
  const around = [[9, -6], [9, 12], [-15, -6], [-15, 12], [-3, -10], [-3, 18], [14, 4], [-20, 4],
                  [18, -14], [18, 20], [-26, -14], [-26, 20]];
  const taken = spots.map(({ x, y }) => [x - 6, y - 6, x + 6, y + 6]);
  return spots.map(({ x, y, letter }) => {
    const box = ([dx, dy]) => [x + dx, y + dy - 10, x + dx + 7 * letter.length, y + dy + 1];
    const cover = (a) => taken.filter((b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3])
      .length;
    const best = around.reduce((a, b) => (cover(box(b)) < cover(box(a)) ? b : a));
    taken.push(box(best));
    return best;
  });
}

function drawPlane(points, front, selection, marks, width, height) {
  const drawn = (residual) => Math.max(residual, floor);
  const residuals = points.flatMap((point) => point.residual.map(drawn));
  const times = points.flatMap((point) => point.time);
  const decade = (value, up) => 10 ** (up ? Math.ceil : Math.floor)(Math.log10(value) + (up ? 1e-9 : -1e-9));
  const domainY = [decade(Math.min(...residuals), false),
                   decade(Math.max(selection.tolerance, ...residuals), true)];
  const domainX = [Math.min(...times) / 1.6, Math.max(...times) * 1.6];
  if (domainX[1] < 10 * domainX[0]) {
    const middle = Math.sqrt(domainX[0] * domainX[1]);
    domainX.splice(0, 2, middle / 3.3, middle * 3.3);
  }
  const plot = Plot.plot({
    width, height, marginLeft: 62, marginBottom: 44, marginTop: 14, marginRight: 14,
    x: { type: "log", domain: domainX, label: null, ticks: logTicks(domainX),
         tickFormat: (ms) => duration(ms * 1e6) },
    y: { type: "log", domain: domainY, label: null, ticks: 8, tickFormat: power },
    marks: [
      Plot.gridX(logTicks(domainX), { stroke: "#e4e4e4", strokeOpacity: 1 }),
      Plot.gridY({ ticks: 8, stroke: "#e4e4e4", strokeOpacity: 1 }),
      Plot.ruleY([selection.tolerance], { stroke: "#888", strokeDasharray: "4,3" }),
      Plot.line(front, { x: (p) => p.time[1], y: (p) => drawn(p.residual[1]), curve: "step-after",
                         stroke: "#888", strokeWidth: 5, strokeOpacity: 0.35 }),
      Plot.dot(front, { x: (p) => p.time[1], y: (p) => drawn(p.residual[1]), r: 10, fill: "#888",
                        fillOpacity: 0.3 }),
      Plot.ruleY(points, { x1: (p) => p.time[0], x2: (p) => p.time[2],
                           y: (p) => drawn(p.residual[1]),
                           stroke: (p) => marks[p.variant].colour, strokeWidth: 1.6 }),
      Plot.ruleX(points, { y1: (p) => drawn(p.residual[0]), y2: (p) => drawn(p.residual[2]),
                           x: (p) => p.time[1],
                           stroke: (p) => marks[p.variant].colour, strokeWidth: 1.6 }),
    ],
  });
  const scaleX = plot.scale("x"), scaleY = plot.scale("y");
  const spots = points.map((p) => ({ x: scaleX.apply(p.time[1]), y: scaleY.apply(drawn(p.residual[1])),
                                     letter: marks[p.variant].letter }));
  const places = letterPlaces(spots);
  const group = placed(plot, 0, 0);
  points.forEach((point, i) => {
    const mark = marks[point.variant], { x, y } = spots[i], [dx, dy] = places[i];
    const title = svg("title");
    title.textContent = `${selection.run.variants[point.variant].label}: median ${
      duration(point.time[1] * 1e6)}, residual ${figure(point.residual[1])}, solved ${
      point.solved} of ${point.counted}`;
    group.append(svg("g", {},
      svg("path", { d: shapeOf(mark.symbol, 80), transform: `translate(${x},${y})`,
                    fill: mark.colour, stroke: "white", "stroke-width": 1 }, title),
      text(x + dx, y + dy, mark.letter, { "font-weight": 600, stroke: "white", "stroke-width": 3,
                                          "paint-order": "stroke" })));
  });
  group.append(text(62, 10, `natural residual (scaled), median of the solved; lower left is better`,
                    { fill: "#444" }),
               text(width - 14, height - 6, "time of one solve, median of the solved",
                    { fill: "#444", "text-anchor": "end" }),
               text(width - 18, scaleY.apply(selection.tolerance) - 5,
                    `solved: at most ${tolerance(selection.tolerance)}`,
                    { fill: "#666", "text-anchor": "end", stroke: "white", "stroke-width": 3,
                      "paint-order": "stroke" }));
  return group;
}

const laneHeight = 19;

/** A lane per solver: its key, and a bar that is as long as the corpus. */
function drawLanes(points, selection, marks, width) {
  const longest = Math.max(...points.map((p) => selection.run.variants[p.variant].label.length));
  const nameWidth = Math.min(50 + 6.3 * longest, width * 0.62);
  const barLeft = nameWidth + 8, barWidth = width - barLeft - 52;
  const most = Math.max(...points.map((p) => p.instances));
  const group = svg("g", { "font-size": 11.5 });
  points.forEach((point, i) => {
    const mark = marks[point.variant], y = 40 + i * laneHeight;
    const label = selection.run.variants[point.variant].label;
    const fitting = Math.floor((nameWidth - 50) / 6);
    group.append(
      svg("path", { d: shapeOf(mark.symbol, 60), transform: `translate(8,${y})`, fill: mark.colour }),
      text(19, y + 4, mark.letter, { "font-weight": 600 }),
      text(40, y + 4, label.length > fitting ? `${label.slice(0, fitting - 1)}…` : label));
    let x = barLeft;
    for (const [fate, name, fill] of fates) {
      if (point.mass[fate] === 0) continue;
      const w = barWidth * point.mass[fate] / most;
      const title = svg("title");
      title.textContent = `${label}: ${name} ${point.mass[fate]} of ${point.instances}`;
      group.append(svg("rect", { x, y: y - 7, width: w, height: 14, fill, stroke: "#555",
                                 "stroke-width": 0.5 }, title));
      if (w > 7.5 * String(point.mass[fate]).length + 3)
        group.append(text(x + w / 2, y + 4, point.mass[fate], { "text-anchor": "middle",
                                                                "font-size": 11 }));
      x += w;
    }
    group.append(text(x + 5, y + 4, `= ${point.instances}`, { fill: "#444" }));
  });
  const used = fates.filter(([fate]) => points.some((point) => point.mass[fate] > 0));
  let x = 0, y = 0;
  for (const [, name, fill] of used) {
    const w = 24 + 6.2 * name.length;
    if (x + w > width) { x = 0; y += 15; }
    group.append(svg("rect", { x, y: y - 4, width: 10, height: 10, fill, stroke: "#555",
                               "stroke-width": 0.5 }), text(x + 14, y + 5, name));
    x += w;
  }
  return { group, height: 40 + points.length * laneHeight };
}

export function planeSection(selection, marks, widths) {
  let least = 0.9;
  const draw = (width) => {
    const points = selection.variants().map((v) => pointOf(v, selection.rowsOf.get(v)));
    if (points.length === 0) return { nothing: "No solver is shown." };
    const placedPoints = points.filter((point) => point.time);
    const front = paretoFront(placedPoints.filter((p) => p.solved >= least * p.counted));
    const subtitle = `${selection.instances.size} instances, judged at ${
      tolerance(selection.tolerance)}. Bars: quartiles. ${front.length
      ? `Grey: Pareto front of solvers that solve at least ${percent(least)} of what counts for them.`
      : `No solver solves ${percent(least)} of what counts for it: no Pareto front.`}`;
    const head = headHeight(width, subtitle) + 8;
    const beside = width >= 900;
    const planeWidth = beside ? Math.round(width * 0.54) : width;
    const lanesWidth = beside ? width - planeWidth - 16 : width;
    const lanes = drawLanes(points, selection, marks, lanesWidth);
    const planeHeight = beside ? Math.max(430, Math.min(lanes.height, 640)) : 430;
    const plane = placedPoints.length
      ? drawPlane(placedPoints, front, selection, marks, planeWidth, planeHeight)
      : text(20, 40, "No solver solved an instance at this tolerance.", { fill: "#444" });
    plane.setAttribute("transform", `translate(0,${head})`);
    lanes.group.setAttribute("transform", beside ? `translate(${planeWidth + 16},${head + 10})`
                                                 : `translate(0,${head + planeHeight + 14})`);
    const height = beside ? head + Math.max(planeHeight, lanes.height + 10)
                          : head + planeHeight + lanes.height + 14;
    const drawing = sheet({ width, height, title: `Time against accuracy: ${selection.title()}`,
                            subtitle, parts: [plane, lanes.group] });
    const onFront = new Set(front.map((point) => point.variant));
    const numbers = numbersTable(
      ["solver", ...fates.map(([, name]) => name), "instances", "time q1", "median ms", "q3",
       "residual q1", "median", "q3", "on the front"],
      points.map((p) => ({
        attributes: { "data-solver": selection.run.variants[p.variant].solver,
                      "data-time": p.time?.[1] ?? "", "data-residual": p.residual?.[1] ?? "",
                      "data-mass": fates.reduce((sum, [fate]) => sum + p.mass[fate], 0) },
        cells: [selection.run.variants[p.variant].label, ...fates.map(([fate]) => p.mass[fate]),
                p.instances, ...(p.time ?? [null, null, null]).map(figure),
                ...(p.residual ?? [null, null, null]).map(figure),
                onFront.has(p.variant) ? "yes" : ""],
      })));
    return { drawing, numbers };
  };
  const chosen = select("Pareto front of solvers that solve at least", "front-least",
    [["0", "anything"], ["0.5", "50 %"], ["0.9", "90 %"], ["1", "100 %"]], "0.9",
    (value) => { least = +value; part.redraw(); });
  const part = chartSection({
    id: "plane", heading: "Speed against accuracy", widths, selection, choices: [chosen], draw,
    explanation: "Each symbol is a solver at the median time and the median residual of the instances "
      + "it solved. A point says nothing of what was not solved: the bars at the edge do, and each is "
      + "as long as the corpus.",
  });
  return part;
}
