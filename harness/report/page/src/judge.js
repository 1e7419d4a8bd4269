// Verdicts at the tolerance that is shown: the rule of `rejudge` and `make_table` in harness/tables.

/**
 * The verdict of a row at a tolerance: {verdict, column, unclaimed}. Columns are those of the table:
 * success, trivial, no_solution, cycle, error, unsupported, not_run.
 */
export function judge(run, row, tolerance) {
  let { verdict, unclaimed, trivial } = row;
  if (tolerance !== run.ownTolerance && row.accuracy) {
    const { residual, zero_residual } = row.accuracy;
    if (row.claim === "solved")
      verdict = residual <= tolerance ? "solved" : residual <= row.tolerance ? "inaccurate" : "wrong";
    unclaimed = row.claim !== "solved" && verdict !== "unsupported" && residual <= tolerance;
    trivial = zero_residual <= tolerance;
  }
  let column = run.columnOf.get(verdict);
  if (column === "success" && trivial) column = "trivial";
  return { verdict, column, unclaimed };
}

/** Whether a row belongs to the denominator of shares: success + failure of the table. */
export function counts(column) {
  return column !== "trivial" && column !== "unsupported" && column !== "not_run";
}

export const failures = ["no_solution", "cycle", "error"];
