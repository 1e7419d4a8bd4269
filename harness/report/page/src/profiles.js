// Performance profiles (Dolan and More): share of instances that a solver solves within a factor of
// the best solver of each.

import { chartSection, numbersTable } from "./chart_section.js";
import { drawCurves, leftOut } from "./cumulative.js";
import { select } from "./dom.js";
import { counts } from "./judge.js";
import { logTicks, percent, tolerance } from "./numbers.js";

export const measures = {
  time: { name: "time", of: (row) => row.median_ns },
  pivots: { name: "pivots", of: (row) => row.work.pivots },
  nodes: { name: "nodes", of: (row) => row.work.nodes },
  factorisations: { name: "factorisations", of: (row) => row.work.factorisations },
};

/**
 * Ratios to the best of `variants` on each instance: {variant, counted, ratios}, ratios of the solved
 * ascending. A count of 0 stands as 1, so that ratios exist. Variants whose measure is 0 wherever they
 * solve do not count it (a sweep is no pivot); they take no part and are in `without`.
 */
export function profiles(selection, variants, measure) {
  const solvedOf = (v) => selection.rowsOf.get(v).filter((each) => each.column === "success");
  const counting = (v) => {
    const solved = solvedOf(v);
    return solved.length === 0 || solved.some((each) => measure.of(each.row) > 0);
  };
  const taking = variants.filter(counting);
  const cost = (each) => Math.max(measure.of(each.row), 1);
  const best = new Map();
  for (const v of taking)
    for (const each of solvedOf(v)) {
      const { instance } = each.row;
      best.set(instance, Math.min(best.get(instance) ?? Infinity, cost(each)));
    }
  return {
    without: variants.filter((v) => !counting(v)),
    curves: taking.map((variant) => ({
      variant,
      counted: selection.rowsOf.get(variant).filter((each) => counts(each.column)).length,
      ratios: solvedOf(variant).map((each) => cost(each) / best.get(each.row.instance))
        .sort((a, b) => a - b),
    })).filter((curve) => curve.counted > 0),
  };
}

const marksOfRatio = [1, 1.5, 2, 5, 10, 100];

export function profileSection(selection, marks, widths) {
  let chosen = "time";
  const draw = (width) => {
    const { run } = selection;
    const measure = measures[chosen];
    const { curves, without } = profiles(selection, selection.variants(), measure);
    if (curves.every((curve) => curve.ratios.length === 0))
      return { nothing: "No instance is solved at this tolerance by a solver that counts this." };
    const most = Math.max(2, ...curves.map((curve) => curve.ratios.at(-1) ?? 1)) * 1.1;
    const lines = curves.map(({ variant, counted, ratios }) => {
      const points = [[1, ratios.filter((ratio) => ratio <= 1).length / counted]];
      ratios.forEach((ratio, i) => { if (ratio > 1) points.push([ratio, (i + 1) / counted]); });
      points.push([most, ratios.length / counted]);
      const unsolved = counted - ratios.length;
      return { points, mark: marks[variant], name: run.variants[variant].label,
               tail: unsolved === 0 ? "all solved" : `${unsolved} of ${counted} unsolved` };
    });
    const absent = without.length
      ? `Not here, since they count no ${measure.name}: ${
          without.map((v) => run.variants[v].label).join(", ")}. ` : "";
    const drawing = drawCurves({
      curves: lines, width,
      x: { domain: [1, most], ticks: logTicks([1, most]), tickFormat: (ratio) => `${+ratio.toPrecision(3)}` },
      title: `Performance profile by ${measure.name}: ${selection.title()}`,
      subtitle: `Share of instances solved to ${tolerance(selection.tolerance)} within a factor of the `
        + `best of the ${curves.length} solvers shown; unsolved is infinitely far from it. ${absent}${
          leftOut(selection)}`,
      xLabel: `${measure.name} over the least of all solvers shown, per instance`,
      yLabel: "share of the instances that count" });
    const numbers = numbersTable(
      ["share within a factor of", ...marksOfRatio, "unsolved", "of"],
      curves.map(({ variant, counted, ratios }) => ({
        attributes: { "data-solver": run.variants[variant].solver, "data-counted": counted,
                      "data-best": ratios.filter((ratio) => ratio <= 1).length,
                      "data-unsolved": counted - ratios.length },
        cells: [run.variants[variant].label,
                ...marksOfRatio.map((mark) =>
                  percent(ratios.filter((ratio) => ratio <= mark).length / counted)),
                counted - ratios.length, counted] })));
    return { drawing, numbers };
  };
  const part = chartSection({
    id: "profile", heading: "Performance profile", widths, selection, draw,
    choices: [select("Measure", "measure", Object.entries(measures).map(([k, m]) => [k, m.name]),
                     chosen, (value) => { chosen = value; part.redraw(); })],
    explanation: "At 1 stands how often a solver is the best; a curve ends at the share it solves. "
      + "Ratios are to the best of the solvers that are shown: hiding one changes them.",
  });
  return part;
}
