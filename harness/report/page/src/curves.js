// Figures of shares that grow along a logarithmic axis, and what they count.

import { logTicks, percent } from "./numbers.js";

/** Steps of a cumulative distribution from `from` to `to`: [x, share]. */
export function steps(values, total, from, to) {
  const points = [[from, 0]];
  values.forEach((value, i) => points.push([value, i / total], [value, (i + 1) / total]));
  points.push([to, values.length / total]);
  return points;
}

/** What stands out of the denominators, in words. */
export function leftOut(selection) {
  const names = { trivial: "trivial", unsupported: "unsupported", not_run: "not run" };
  const parts = selection.variants().flatMap((variant) => {
    const rows = selection.rowsOf.get(variant);
    const some = Object.entries(names)
      .map(([column, name]) => [rows.filter((each) => each.column === column).length, name])
      .filter(([number]) => number > 0);
    return some.length
      ? [`${selection.run.variants[variant].label} ${some.map((s) => s.join(" ")).join(", ")}`] : [];
  });
  return parts.length ? `Left out of denominators: ${parts.join("; ")}.` : "";
}

const lineHeight = 17;

/**
 * A figure of `curves`, {points, mark, name, tail}, with a legend beside it from the highest end down.
 * `x` is {domain, format} and may hold `ticks`; the middle of a long name gives way.
 */
export function curvesFigure({ curves, width, title, caption, x, xLabel, yLabel }) {
  const room = width >= 900 ? 390 : 320;
  const height = Math.max(330, lineHeight * curves.length + 10);
  const area = [64, width - room - 74, 34, height];
  const named = ({ mark, name, tail }) => {
    const letters = Math.floor((room - 50) / 6.4) - tail.length - mark.letter.length - 3;
    const half = Math.floor((letters - 1) / 2);
    const fitting = name.length > letters ? `${name.slice(0, letters - 1 - half)}…${name.slice(-half)}`
                                          : name;
    return `${mark.letter} ${fitting}: ${tail}`.trim();
  };
  const byEnd = [...curves].sort((a, b) => b.points.at(-1)[1] - a.points.at(-1)[1]);
  return {
    title, caption, width, height: height + 80,
    panels: [{
      area,
      x: { low: x.domain[0], high: x.domain[1], log: true, label: xLabel,
           ticks: (x.ticks ?? logTicks(x.domain)).map((tick) => [tick, x.format(tick)]) },
      y: { low: 0, high: 1.01, label: yLabel,
           ticks: [0, 0.2, 0.4, 0.6, 0.8, 1].map((share) => [share, percent(share)]) },
      series: curves.map(({ points, mark, name, tail }) => ({
        kind: "line", size: 1.9,
        marks: points.map(([px, py]) => ({ x: px, y: py, look: mark.look, text: `${name}: ${tail}` })) })),
    }],
    legend: byEnd.map((curve) => ({ name: named(curve), look: curve.mark.look, line: true,
                                    point: curve.mark.letter !== "" })),
    legend_area: [width - room + 6, 380, area[2], height],
  };
}
