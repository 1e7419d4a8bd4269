// Cumulative curves: how many instances are solved to an accuracy within a time, and how accurately
// within a given time; and the time it takes to reach each accuracy.

import { chartSection, numbersTable } from "./chart_section.js";
import { curvesFigure, leftOut, steps } from "./curves.js";
import { select } from "./dom.js";
import { duration, logTicks, power, tolerance } from "./numbers.js";
import { ascending } from "./quantile.js";

/** Variants with the rows that count for them at an accuracy: the denominator of shares. */
function countedAt(selection, accuracy, variants = selection.variants()) {
  const rowsOf = selection.rowsAt(accuracy);
  return variants.map((v) => [v, rowsOf.get(v).filter((each) => each.counted)])
    .filter(([, rows]) => rows.length > 0);
}

/** Times (ns), ascending, of the solved among judged rows. */
function solvedTimes(rows) {
  return ascending(rows.filter(({ column, row }) => column === "success" && row.median_ns !== null)
    .map(({ row }) => row.median_ns));
}

/** What curves of one solver look like, by accuracy from rough to fine. */
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
    const all = countedAt(selection, selection.tolerance);
    const sets = one === "all"
      ? all.map(([v, rows]) => ({ rows, mark: marks[v], name: run.variants[v].label }))
      : run.tolerances.map((accuracy, i) => ({
          rows: countedAt(selection, accuracy, [+one])[0]?.[1] ?? [], name: `to ${tolerance(accuracy)}`,
          mark: { letter: "", look: { colour: ramp[Math.min(i, ramp.length - 1)], dash: i % 3 } } }));
    const times = sets.map(({ rows }) => solvedTimes(rows));
    const every = times.flat();
    if (every.length === 0)
      return { nothing: "No instance is solved at this tolerance by a solver that is shown." };
    const from = Math.min(...every) / 1.2, to = Math.max(...every) * 1.2;
    const figure = curvesFigure({
      curves: sets.map(({ rows, mark, name }, i) => ({
        mark, name, points: steps(times[i], Math.max(rows.length, 1), from, to),
        tail: `${times[i].length} of ${rows.length}` })),
      width, x: { domain: [from, to], format: duration },
      title: `Solved within a time: ${selection.title()}`,
      caption: (one === "all"
        ? `Share of instances solved to ${tolerance(selection.tolerance)} within the time. `
        : `${run.variants[+one].label}: share of instances solved to each accuracy. `)
        + leftOut(selection),
      xLabel: "time of one solve", yLabel: "share of the instances that count" });
    return { figure, numbers: timeToReach(selection) };
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
function timeToReach(selection) {
  const { run } = selection;
  const byAccuracy = run.tolerances.map((accuracy) => new Map(countedAt(selection, accuracy)));
  return numbersTable(
    ["time to solve 50 % / 90 % to", ...run.tolerances.map(tolerance)],
    selection.variants().map((v) => ({
      attributes: { "data-solver": run.variants[v].solver },
      cells: [run.variants[v].label, ...byAccuracy.map((counted) => {
        const rows = counted.get(v) ?? [], times = solvedTimes(rows);
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
    const curves = countedAt(selection, selection.tolerance).map(([v, rows]) => {
      const reached = ascending(rows
        .filter(({ row }) => row.claim === "solved" && row.accuracy && row.median_ns <= most)
        .map(({ row }) => row.accuracy.residual));
      const within = (residual) => `${reached.filter((r) => r <= residual).length} of ${rows.length}`;
      return { v, within, mark: marks[v], name: run.variants[v].label, tail: within(selection.tolerance),
               points: steps(reached.filter((r) => r <= highest).map((r) => Math.max(r, lowest)),
                             rows.length, lowest, highest) };
    });
    if (curves.length === 0) return { nothing: "No row counts here." };
    const figure = curvesFigure({
      curves, width,
      x: { domain: [lowest, highest], format: power,
           ticks: logTicks([lowest, highest]).filter((_, i) => i % 2 === 1) },
      title: `Accuracy reached ${limit === "none" ? "at any time" : `within ${duration(most)}`}: ${
        selection.title()}`,
      caption: `Share of instances whose answer has at most this residual and is claimed as solved; at `
        + `the right how many reach ${tolerance(selection.tolerance)}. ` + leftOut(selection),
      xLabel: "natural residual (scaled); more digits to the left",
      yLabel: "share of the instances that count" });
    const numbers = numbersTable(
      ["share with a residual of at most", ...run.tolerances.map(tolerance)],
      curves.map(({ v, within }) => ({
        attributes: { "data-solver": run.variants[v].solver },
        cells: [run.variants[v].label, ...run.tolerances.map(within)] })));
    return { figure, numbers };
  };
  const part = chartSection({
    id: "accuracy", heading: "Accuracy reached in a given time", widths, selection, choices: [place],
    draw,
    explanation: "A curve rises where an answer has that residual: the farther left, the more digits. "
      + "Residuals of 1e-17 and below, 0 too, are drawn at the left edge.",
  });
  return part;
}
