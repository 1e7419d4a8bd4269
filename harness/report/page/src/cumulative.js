// Cumulative curves: how many instances are solved to an accuracy within a time, and how accurately
// within a given time; and the time it takes to reach each accuracy.

import * as Plot from "@observablehq/plot";
import { chartSection, numbersTable } from "./chart_section.js";
import { select } from "./dom.js";
import { endLabels, roomFor } from "./end_labels.js";
import { counts, judge } from "./judge.js";
import { duration, logTicks, percent, power, tolerance } from "./numbers.js";
import { headHeight, placed, sheet, text } from "./sheet.js";

export const labelRoom = (width) => (width >= 900 ? 390 : 320);

/** Rows that count at the tolerance that is shown: the denominator of all shares here. */
function counted(selection, variant) {
  return selection.rowsOf.get(variant).filter((each) => counts(each.column));
}

/** What stands out of the denominators, in words. */
export function leftOut(selection) {
  const names = { trivial: "trivial", unsupported: "unsupported", not_run: "not run" };
  const parts = selection.variants().flatMap((variant) => {
    const rows = selection.rowsOf.get(variant);
    const some = Object.keys(names)
      .map((column) => [names[column], rows.filter((each) => each.column === column).length])
      .filter(([, number]) => number > 0);
    return some.length
      ? [`${selection.run.variants[variant].label} ${some.map((s) => s.reverse().join(" ")).join(", ")}`]
      : [];
  });
  return parts.length ? `Left out of denominators: ${parts.join("; ")}.` : "";
}

/** Times (ns), ascending, at which `rows` were solved to an accuracy. */
function solvedTimes(run, rows, accuracy) {
  return rows.filter(({ row }) => judge(run, row, accuracy).verdict === "solved" &&
                                  row.median_ns !== null)
    .map(({ row }) => row.median_ns).sort((a, b) => a - b);
}

/** Letter, name and what is said of a curve; the middle of the name gives way where it is too long. */
function labelOf({ mark, name, tail }, room) {
  const letters = Math.floor(room / 6.1) - tail.length - mark.letter.length - 3;
  const half = Math.floor((letters - 1) / 2);
  const fitting = name.length > letters ? `${name.slice(0, letters - 1 - half)}…${name.slice(-half)}`
                                        : name;
  return `${mark.letter} ${fitting}: ${tail}`.trim();
}

/** Curves of shares on a logarithmic axis, labelled at their right ends. */
export function drawCurves({ curves, width, title, subtitle, x, xLabel, yLabel, height = 380 }) {
  const room = labelRoom(width);
  const head = headHeight(width, subtitle) + 18;
  const tall = Math.max(height, roomFor(curves.length) + 70);
  const points = curves.flatMap((curve) => curve.points.map(([px, py]) => ({ px, py, curve })));
  const plot = Plot.plot({
    width: width - room, height: tall, marginLeft: 52, marginBottom: 40, marginTop: 8, marginRight: 6,
    x: { type: "log", label: null, ...x },
    y: { domain: [0, 1], label: null, tickFormat: (share) => percent(share) },
    marks: [
      Plot.gridX(x.ticks, { stroke: "#e4e4e4", strokeOpacity: 1 }),
      Plot.gridY({ stroke: "#e4e4e4", strokeOpacity: 1 }),
      Plot.ruleY([0], { stroke: "#666" }),
      ...curves.map((curve) => Plot.line(curve.points, {
        x: (p) => p[0], y: (p) => p[1], curve: "step-after", stroke: curve.mark.colour,
        strokeWidth: 1.9, strokeDasharray: curve.mark.dash === "none" ? null : curve.mark.dash,
        title: () => `${curve.name}: ${curve.tail}` })),
    ],
  });
  const scale = plot.scale("y");
  const ends = curves.map((curve) => ({ y: scale.apply(curve.points.at(-1)?.[1] ?? 0) + head,
                                        mark: curve.mark, words: labelOf(curve, room - 50) }));
  return points.length === 0 ? null : sheet({
    width, height: head + tall, title, subtitle,
    parts: [
      placed(plot, 0, head),
      text(0, head - 4, yLabel, { fill: "#444" }),
      text(width - room - 6, head + tall - 6, xLabel, { fill: "#444", "text-anchor": "end" }),
      endLabels(ends, width - room - 4, head + 8, head + tall - 42),
    ],
  });
}

/** Steps of a cumulative distribution from `from` to `to`: [x, share]. */
function steps(values, total, from, to) {
  const points = [[from, 0]];
  values.forEach((value, i) => points.push([value, (i + 1) / total]));
  points.push([to, values.length / total]);
  return points;
}

/** What curves of one solver look like, by accuracy from rough to fine. */
const grey = { colour: "#999", dash: "none", symbol: "circle", letter: "" };
const ramp = ["#c6dbef", "#9ecae1", "#6baed6", "#4a98c9", "#2e7ebc", "#1764ab", "#0f5291", "#084078",
              "#062d5a", "#000000"];

export function withinTimeSection(selection, marks, widths) {
  let one = "all";
  const place = document.createElement("span");
  const chooser = () => {
    const shown = selection.variants();
    if (one !== "all" && !shown.includes(+one)) one = "all";
    place.replaceChildren(select("Curves", "cumulative-of",
      [["all", `of all shown solvers, to ${tolerance(selection.tolerance)}`],
       ...shown.map((v) => [String(v), `of ${selection.run.variants[v].label}, to each accuracy`])],
      one, (value) => { one = value; part.redraw(); }));
  };
  const draw = (width) => {
    chooser();
    const { run } = selection;
    const variants = selection.variants();
    const all = variants.map((v) => [v, counted(selection, v)]).filter(([, rows]) => rows.length > 0);
    const sets = one === "all"
      ? all.map(([v, rows]) => ({ rows, accuracy: selection.tolerance, mark: marks[v],
                                  name: run.variants[v].label }))
      : run.tolerances.map((accuracy, i) => ({
          rows: counted(selection, +one), accuracy, name: `to ${tolerance(accuracy)}`,
          mark: { ...grey, colour: ramp[Math.min(i, ramp.length - 1)],
                  dash: ["none", "6,3", "2,2"][i % 3] } }));
    const times = sets.map((set) => solvedTimes(run, set.rows, set.accuracy));
    const every = times.flat();
    if (every.length === 0)
      return { nothing: "No instance is solved at this tolerance by a solver that is shown." };
    const from = Math.min(...every) / 1.2, to = Math.max(...every) * 1.2;
    const curves = sets.map((set, i) => ({
      mark: set.mark, points: steps(times[i], set.rows.length, from, to),
      name: set.name, tail: `${times[i].length} of ${set.rows.length}` }));
    const drawing = drawCurves({
      curves, width, x: { domain: [from, to], ticks: logTicks([from, to]), tickFormat: duration },
      title: `Solved within a time: ${selection.title()}`,
      subtitle: (one === "all"
        ? `Share of instances solved to ${tolerance(selection.tolerance)} within the time. `
        : `${run.variants[+one].label}: share of instances solved to each accuracy. `)
        + leftOut(selection),
      xLabel: "time of one solve", yLabel: "share of the instances that count" });
    return { drawing, numbers: timeToReach(selection, all) };
  };
  const part = chartSection({
    id: "cumulative", heading: "Solved within a time", widths, selection, choices: [place], draw,
    explanation: "A curve rises where an instance is solved, and ends at the share that is solved at "
      + "all. Time is that of the whole solve as it was run: a solver does not stop earlier for a "
      + "lower accuracy, but its answer may fall short of a higher one.",
  });
  return part;
}

/** Time within which half, and nine in ten, of the instances are solved to each accuracy. */
function timeToReach(selection, all) {
  const { run } = selection;
  return numbersTable(
    ["time to solve 50 % / 90 % to", ...run.tolerances.map(tolerance)],
    all.map(([v, rows]) => ({
      attributes: { "data-solver": run.variants[v].solver },
      cells: [run.variants[v].label, ...run.tolerances.map((accuracy) => {
        const times = solvedTimes(run, rows, accuracy);
        const reach = (p) => duration(times[Math.max(Math.ceil(p * rows.length), 1) - 1] ?? null);
        return `${reach(0.5)} / ${reach(0.9)}`;
      })] })));
}

/** 1, 2, 5, 10, ... from the fastest solve to the slowest, ns. */
function roundTimes(rows) {
  const times = rows.map((each) => each.row.median_ns).filter((ns) => ns);
  if (times.length === 0) return [];
  const [low, high] = [Math.min(...times), Math.max(...times)];
  const list = [];
  for (let power = Math.floor(Math.log10(low)); 10 ** power < high; ++power)
    for (const digit of [1, 2, 5])
      if (digit * 10 ** power > low && digit * 10 ** power < high) list.push(digit * 10 ** power);
  return list;
}

export function accuracySection(selection, marks, widths) {
  let limit = "none";
  const place = document.createElement("span");
  const draw = (width) => {
    const { run } = selection;
    const choices = roundTimes(selection.rows);
    if (limit !== "none" && !choices.includes(+limit)) limit = "none";
    place.replaceChildren(select("Time given", "time-given",
      [["none", "as long as it takes"], ...choices.map((ns) => [String(ns), duration(ns)])],
      limit, (value) => { limit = value; part.redraw(); }));
    const most = limit === "none" ? Infinity : +limit;
    const lowest = 1e-17, highest = 1e-2;
    const curves = selection.variants().map((v) => [v, counted(selection, v)])
      .filter(([, rows]) => rows.length > 0)
      .map(([v, rows]) => {
        const reached = rows
          .filter(({ row }) => row.claim === "solved" && row.accuracy && row.median_ns <= most &&
                               row.accuracy.residual <= highest)
          .map(({ row }) => Math.max(row.accuracy.residual, lowest)).sort((a, b) => a - b);
        const points = steps(reached, rows.length, lowest, highest);
        const good = reached.filter((r) => r <= selection.tolerance).length;
        return { v, mark: marks[v], points, good, all: rows.length,
                 name: run.variants[v].label,
                 tail: `${good} of ${rows.length}` };
      });
    if (curves.length === 0) return { nothing: "No row counts here." };
    const drawing = drawCurves({
      curves, width,
      x: { domain: [lowest, highest], ticks: logTicks([lowest, highest]).filter((_, i) => i % 2 === 1), tickFormat: power },
      title: `Accuracy reached ${limit === "none" ? "at any time" : `within ${duration(most)}`}: ${
        selection.title()}`,
      subtitle: `Share of instances whose answer has at most this residual and is claimed as solved; at `
        + `the right how many reach ${tolerance(selection.tolerance)}. ` + leftOut(selection),
      xLabel: "natural residual (scaled); more digits to the left",
      yLabel: "share of the instances that count" });
    const levels = run.tolerances;
    const numbers = numbersTable(
      ["share with a residual of at most", ...levels.map(tolerance)],
      curves.map((curve) => ({
        attributes: { "data-solver": run.variants[curve.v].solver },
        cells: [run.variants[curve.v].label, ...levels.map((level) => {
          const rows = counted(selection, curve.v);
          const good = rows.filter(({ row }) => judge(run, row, level).verdict === "solved" &&
                                                row.median_ns <= most).length;
          return `${good} of ${rows.length}`;
        })] })));
    return { drawing, numbers };
  };
  const part = chartSection({
    id: "accuracy", heading: "Accuracy reached in a given time", widths, selection, choices: [place],
    draw,
    explanation: "A curve rises where an answer has that residual: the farther left, the more digits. "
      + "Residuals of 1e-17 and below, 0 too, are drawn at the left edge.",
  });
  return part;
}
