// The plane: median time against median accuracy of each solver, with quartiles, the Pareto front, and
// at its edge what became of every instance of the corpus.

import { chartSection, numbersTable } from "./chart_section.js";
import { duration, figure, logTicks, power, tolerance } from "./numbers.js";
import { ascending, quantile } from "./quantile.js";

const floor = 1e-18;  // Residuals below, 0 too, are drawn here.

const fates = [
  ["success", "solved", "#8fc9a8"],
  ["trivial", "trivial", "#d9efe2"],
  ["no_solution", "no solution", "#f0b84a"],
  ["cycle", "cycle or limit", "#f2e27a"],
  ["error", "error", "#dd7a4a"],
  ["unsupported", "unsupported", "#c4c4c4"],
  ["not_run", "not run", "#e8e8e8"],
];

function spread(values) {
  const sorted = ascending(values);
  return [0.25, 0.5, 0.75].map((p) => quantile(sorted, p));
}

function pointOf(variant, rows) {
  const mass = Object.fromEntries(fates.map(([fate]) => [fate, 0]));
  for (const each of rows) ++mass[each.column];
  const solved = rows.filter((each) => each.column === "success");
  const counted = rows.filter((each) => each.counted).length;
  const point = { variant, mass, instances: rows.length, counted, solved: solved.length };
  const times = solved.map((each) => each.row.median_ns).filter((ns) => ns !== null);
  if (times.length === 0) return point;
  return {
    ...point,
    time: spread(times.map((ns) => ns * 1e-6)),
    residual: spread(solved.map((each) => each.row.accuracy.residual)),
  };
}

/** Whether a is as good as b in median time, median residual and share solved, and better in one. */
function dominates(a, b) {
  const goals = ({ time, residual, solved, counted }) => [time[1], residual[1], -solved / counted];
  const of = goals(b);
  return goals(a).every((value, i) => value <= of[i]) && goals(a).some((value, i) => value < of[i]);
}

/** Points that no other dominates: the front of harness/studies/sheet/sheet.h. */
export function paretoFront(points) {
  return points.filter((point) => !points.some((other) => dominates(other, point)));
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

const black = { colour: "#222222" };
const drawn = (residual) => Math.max(residual, floor);

/** The plane proper: the tolerance, stairs of the front, rings, and points with bars and letters. */
function planePanel(points, front, selection, marks, area) {
  const residuals = points.flatMap((point) => point.residual.map(drawn));
  const times = points.flatMap((point) => point.time);
  const decade = (value, up) => 10 ** (up ? Math.ceil : Math.floor)(Math.log10(value) + (up ? 1e-9 : -1e-9));
  const lowest = decade(Math.min(...residuals), false);
  const highest = decade(Math.max(selection.tolerance, ...residuals), true);
  let fast = Math.min(...times) / 1.6, slow = Math.max(...times) * 1.6;
  if (slow < 10 * fast) {
    const middle = Math.sqrt(fast * slow);
    [fast, slow] = [middle / 3.3, middle * 3.3];
  }
  const [, width, , height] = area;
  const across = width / Math.log(slow / fast), up = height / Math.log(highest / lowest);
  const spots = points.map((p) => ({ x: across * Math.log(p.time[1] / fast),
                                     y: -up * Math.log(drawn(p.residual[1]) / lowest),
                                     letter: marks[p.variant].letter }));
  const letters = letterPlaces(spots).map(([dx, dy], i) => ({
    x: fast * Math.exp((spots[i].x + dx) / across), y: lowest * Math.exp((-spots[i].y - dy + 4) / up),
    text: spots[i].letter, look: black }));
  const grey = { colour: "#888888", dash: 1 }, pale = { colour: "#dddddd" };
  const share = (point) => point.solved / point.counted;
  const most = Math.max(...front.map(share));
  const stairs = [];
  for (const { time, residual } of front.filter((p) => share(p) === most)
    .sort((a, b) => a.time[1] - b.time[1])) {
    stairs.push({ x: time[1], y: stairs.at(-1)?.y ?? highest, look: pale },
                { x: time[1], y: drawn(residual[1]), look: pale });
  }
  stairs.push({ x: slow, y: stairs.at(-1)?.y, look: pale });
  const ticks = logTicks([lowest, highest]);
  const every = Math.ceil(ticks.length / 10);
  return {
    area,
    x: { low: fast, high: slow, log: true, label: "time of one solve, median of the solved",
         ticks: logTicks([fast, slow]).map((ms) => [ms, duration(ms * 1e6)]) },
    y: { low: lowest, high: highest, log: true,
         label: "natural residual (scaled), median of the solved",
         ticks: ticks.filter((_, i) => i % every === 0).map((tick) => [tick, power(tick)]) },
    series: [
      { kind: "line", marks: [{ x: fast, y: selection.tolerance, look: grey },
                              { x: slow, y: selection.tolerance }] },
      { kind: "text", size: 0.95, align: "right", marks: [{
        x: slow, y: selection.tolerance * Math.exp(9 / up), look: grey,
        text: `solved: at most ${tolerance(selection.tolerance)}` }] },
      { kind: "line", size: 5, marks: stairs },
      { kind: "points", size: 1.8, marks: front.map((p) => ({
        x: p.time[1], y: drawn(p.residual[1]), look: black, filled: false })) },
      { kind: "points", marks: points.map((p) => ({
        x: p.time[1], x_low: p.time[0], x_high: p.time[2], look: marks[p.variant].look,
        y: drawn(p.residual[1]), y_low: drawn(p.residual[0]), y_high: drawn(p.residual[2]),
        filled: p.solved === p.counted,
        text: `${selection.run.variants[p.variant].label}: median ${duration(p.time[1] * 1e6)}, residual ${
          figure(p.residual[1])}, solved ${p.solved} of ${p.counted}` })) },
      { kind: "text", marks: letters },
    ],
  };
}

const laneHeight = 19;

/** A lane per solver: its marker and letter, its name, and a bar that is as long as the corpus. */
function lanesPanel(points, selection, marks, [left, width, top]) {
  const labels = points.map((p) => selection.run.variants[p.variant].label);
  const nameWidth = Math.min(50 + 6.3 * Math.max(...labels.map((l) => l.length)), width * 0.62);
  const fitting = Math.floor((nameWidth - 50) / 6);
  const barLeft = nameWidth + 8, barWidth = width - barLeft - 52;
  const most = Math.max(...points.map((p) => p.instances));
  const keys = [], names = [], boxes = [], counts = [];
  points.forEach(({ variant, mass, instances }, y) => {
    const mark = marks[variant], label = labels[y];
    keys.push({ x: 8, y, look: mark.look });
    names.push({ x: 19, y, look: black, text: mark.letter }, { x: 40, y, look: black,
      text: label.length > fitting ? `${label.slice(0, fitting - 1)}…` : label });
    let x = barLeft;
    for (const [fate, name, colour] of fates.filter(([each]) => mass[each] > 0)) {
      const x_high = x + barWidth * mass[fate] / most, count = String(mass[fate]);
      boxes.push({ x_low: x, x_high, y_low: y - 0.37, y_high: y + 0.37, look: { colour },
                   text: `${label}: ${name} ${count} of ${instances}` });
      if (x_high - x > 7.5 * count.length + 3)
        counts.push({ x: (x + x_high) / 2, y, look: black, text: count });
      x = x_high;
    }
    names.push({ x: x + 5, y, look: { colour: "#444444" }, text: `= ${instances}` });
  });
  return {
    area: [left, width, top, laneHeight * points.length], axes: false,
    x: { low: 0, high: width }, y: { low: points.length - 0.5, high: -0.5 },
    series: [{ kind: "boxes", marks: boxes }, { kind: "points", marks: keys },
             { kind: "text", marks: names }, { kind: "text", align: "centre", size: 0.95, marks: counts }],
  };
}

/** The figure: the plane, and beside it, or below where there is no room, the lanes and their key. */
function planeFigure(points, front, selection, marks, width) {
  const placed = points.filter((point) => point.time);
  const beside = width >= 900;
  const lanesTall = laneHeight * points.length + 50;
  const planeTall = beside ? Math.max(390, Math.min(lanesTall, 600)) : 390;
  const planeWidth = (beside ? Math.round(width * 0.54) : width) - 90;
  const left = beside ? planeWidth + 100 : 0, lanesWidth = width - left;
  const lanesTop = beside ? 40 : 40 + planeTall + 60;
  const lanes = lanesPanel(points, selection, marks, [left, lanesWidth, lanesTop]);
  const panels = placed.length
    ? [planePanel(placed, front, selection, marks, [76, planeWidth, 34, planeTall]), lanes] : [lanes];
  return {
    title: `Time against accuracy: ${selection.title()}`,
    caption: `${selection.instances.size} instances, judged at ${tolerance(selection.tolerance)}. ${
      placed.length ? "Bars: quartiles; open markers: some failures. Ringed: on the front of time, "
      + "residual and share solved; grey stairs: the front of those that solve the most."
      : "No solver solved an instance at this tolerance."}`,
    width, height: Math.max(34 + planeTall + 40, lanesTop + lanesTall), panels,
    legend: fates.filter(([fate]) => points.some((point) => point.mass[fate] > 0))
      .map(([, name, colour]) => ({ name, look: { colour, marker: 1 } })),
    legend_area: [left, Math.max(lanesWidth, 401), lanesTop + lanesTall - 46, 34],
  };
}

export function planeSection(selection, marks, widths) {
  const draw = (width) => {
    const points = selection.variants().map((v) => pointOf(v, selection.rowsOf.get(v)));
    if (points.length === 0) return { nothing: "No solver is shown." };
    const front = paretoFront(points.filter((point) => point.time));
    const onFront = new Set(front.map((point) => point.variant));
    const numbers = numbersTable(
      ["solver", ...fates.map(([, name]) => name), "instances", "time q1", "median ms", "q3",
       "residual q1", "median", "q3", "on the front"],
      points.map((p) => ({
        attributes: { "data-solver": selection.run.variants[p.variant].solver,
                      "data-time": p.time?.[1] ?? "", "data-residual": p.residual?.[1] ?? "",
                      "data-front": onFront.has(p.variant) ? "yes" : "no",
                      "data-mass": fates.reduce((sum, [fate]) => sum + p.mass[fate], 0) },
        cells: [selection.run.variants[p.variant].label, ...fates.map(([fate]) => p.mass[fate]),
                p.instances, ...(p.time ?? [null, null, null]).map(figure),
                ...(p.residual ?? [null, null, null]).map(figure),
                onFront.has(p.variant) ? "yes" : ""],
      })));
    return { figure: planeFigure(points, front, selection, marks, width), numbers };
  };
  const part = chartSection({
    id: "plane", heading: "Speed against accuracy", widths, selection, draw,
    explanation: "Each symbol is a solver at the median time and the median residual of the instances "
      + "it solved. A point says nothing of what was not solved: the bars at the edge do, and each is "
      + "as long as the corpus.",
  });
  return part;
}
