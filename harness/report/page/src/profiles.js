// Performance profiles (Dolan and More): share of instances that a solver solves within a factor of
// the best solver of each, as harness/studies/sheet/sheet.h defines them.

import { chartSection, numbersTable } from "./chart_section.js";
import { curvesFigure, leftOut, steps } from "./curves.js";
import { select } from "./dom.js";
import { percent, tolerance } from "./numbers.js";
import { ascending } from "./quantile.js";

/** The measures; `offset` is added to both parts of a ratio, since counts may be 0. */
export const measures = {
  time: { name: "time", of: (row) => row.median_ns ?? Infinity, offset: 0 },
  pivots: { name: "pivots", of: (row) => row.work.pivots, offset: 1 },
  nodes: { name: "nodes", of: (row) => row.work.nodes, offset: 1 },
  factorisations: { name: "factorisations", of: (row) => row.work.factorisations, offset: 1 },
};

/** Registry rows of which some pair brought an answer and none counted any work (a sweep is no pivot). */
function rowsWithout(run, measure) {
  if (measure.offset === 0) return new Set();
  const rowOf = (row) => run.variants[row.variant].row;
  const worked = new Set(run.rows.filter((row) => measure.of(row) > 0).map(rowOf));
  return new Set(run.rows.filter((row) => row.accuracy && row.verdict !== "unsupported").map(rowOf)
    .filter((row) => !worked.has(row)));
}

/**
 * Ratios to the best of `variants` on each instance: {variant, counted, ratios}, ratios of the solved
 * ascending. Variants that do not count the measure take no part and are in `without`.
 */
export function profiles(selection, variants, measure) {
  const { run } = selection;
  const absent = rowsWithout(run, measure);
  const isAbsent = (v) => absent.has(run.variants[v].row);
  const solved = (v) => selection.rowsOf.get(v).filter((each) => each.column === "success");
  const taking = variants.filter((v) => !isAbsent(v));
  const best = new Map();
  for (const { row } of taking.flatMap(solved))
    best.set(row.instance, Math.min(best.get(row.instance) ?? Infinity, measure.of(row)));
  const ratio = ({ row }) =>
    (measure.of(row) + measure.offset) / (best.get(row.instance) + measure.offset);
  return {
    without: variants.filter(isAbsent),
    curves: taking.map((variant) => ({
      variant,
      counted: selection.rowsOf.get(variant).filter((each) => each.counted).length,
      ratios: ascending(solved(variant).map(ratio).filter(Number.isFinite)),
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
    const absent = without.length
      ? `Not here, since they count no ${measure.name}: ${
          without.map((v) => run.variants[v].label).join(", ")}. ` : "";
    const over = measure.offset ? "(c + 1) / (best + 1)" : "c / best";
    const figure = curvesFigure({
      curves: curves.map(({ variant, counted, ratios }) => ({
        points: steps(ratios, counted, 1, most), mark: marks[variant],
        name: run.variants[variant].label,
        tail: counted === ratios.length ? "all solved" : `${counted - ratios.length} of ${counted} unsolved` })),
      width, x: { domain: [1, most], format: (ratio) => `${+ratio.toPrecision(3)}` },
      title: `Performance profile by ${measure.name}: ${selection.title()}`,
      caption: `Share of instances solved to ${tolerance(selection.tolerance)} within a factor of the `
        + `best of the ${curves.length} solvers shown, ${over}; unsolved is infinitely far from it. ${
          absent}${leftOut(selection)}`,
      xLabel: `${measure.name} over the least of all solvers shown, per instance`,
      yLabel: "share of the instances that count" });
    const numbers = numbersTable(
      ["share within a factor of", ...marksOfRatio, "unsolved", "of"],
      curves.map(({ variant, counted, ratios }) => ({
        attributes: { "data-solver": run.variants[variant].solver, "data-counted": counted,
                      "data-best": ratios.filter((ratio) => ratio <= 1).length,
                      "data-unsolved": counted - ratios.length, "data-ratios": ratios.join(" ") },
        cells: [run.variants[variant].label,
                ...marksOfRatio.map((mark) =>
                  percent(ratios.filter((ratio) => ratio <= mark).length / counted)),
                counted - ratios.length, counted] })));
    return { figure, numbers };
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
