// What each verdict is called in a cell, and what it means.

export const verdictSigns = {
  solved: ["s", "claimed solved, and the natural residual is within the tolerance"],
  wrong: ["W", "claimed solved or infeasible, and fails the check"],
  inaccurate: ["A", "passed at the tolerance of the run, not at the smaller one that is shown"],
  ray: ["R", "claimed: nothing blocks the driving variable (secondary ray)"],
  exhausted: ["X", "claimed: the search queue ran empty"],
  infeasible: ["I", "claimed: no w, z >= 0 exist; the certificate was checked"],
  "false-infeasible": ["F", "claimed infeasible, but a checked solution is known"],
  cycle: ["C", "claimed: a basis came back with the same entering variable"],
  limit: ["L", "claimed: pivots, nodes or sweeps ran out"],
  singular: ["N", "claimed: no usable pivot, a singular basis, or non-finite numbers"],
  timeout: ["T", "the solve took longer than it may"],
  memory: ["M", "the worker held more memory than it may"],
  crash: ["!", "the worker died, or an exception left the solver"],
  unsupported: ["–", "the method does not apply to this problem; counts for nobody"],
  "not-run": ["o", "left out as too large; counts for nobody"],
};

export const columnMeanings = [
  ["success", "solved: claimed solved and passed the judge"],
  ["trivial", "solved where z = 0 is a solution too; counted apart, in no share"],
  ["no_solution", "no solution: ray, exhausted, infeasible or false-infeasible"],
  ["cycle", "cycle: cycle, limit or timeout"],
  ["error", "error: wrong, inaccurate, singular, crash or memory"],
  ["unsupported", "unsupported: the method does not apply"],
  ["not_run", "not run: left out as too large"],
];

/** The letter in a cell; a star where z passes although a failure is claimed. */
export function sign({ verdict, column, unclaimed }) {
  const [letter] = verdictSigns[verdict];
  return (column === "trivial" ? "t" : letter) + (unclaimed ? "*" : "");
}
