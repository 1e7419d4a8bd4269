// The data of the run, as the program embedded them (harness/report/report_data.h), as objects: one
// per instance, variant (a solver from a start) and row.

/** Numbers that JSON cannot hold are strings there: "inf", "-inf", "nan". */
export function number(value) {
  if (value === "inf") return Infinity;
  if (value === "-inf") return -Infinity;
  if (value === "nan") return NaN;
  return value;
}

/** The entry of a list in which entries that are all equal are stored once. */
function at(list, index) {
  return Array.isArray(list) ? list[index] : list.all;
}

const residuals = ["residual", "residual_unscaled", "zero_residual", "paper_error", "min_z", "min_w",
                   "max_zw", "backward_error"];

function rowOf(raw, index) {
  const { rows } = raw;
  const get = (name) => (name in rows ? at(rows[name], index) : null);
  const residual = get("residual");
  const accuracy = residual === null
    ? null : Object.fromEntries(residuals.map((name) => [name, number(get(name))]));
  const work = {};
  for (const name of Object.keys(rows))
    if (name.startsWith("work.")) work[name.slice(5)] = get(name);
  return {
    index, accuracy, work,
    instance: get("instance"),
    variant: get("variant"),
    verdict: raw.verdicts[get("verdict")].name,
    claim: get("claim"),
    message: raw.strings[get("message")],
    tolerance: number(get("tolerance")),
    signal: get("signal"),
    stderr: raw.strings[get("stderr")],
    jobs: get("jobs"),
    environment: get("environment"),
    samples: get("samples"),
    median_ns: get("median_ns"),
    least_ns: get("least_ns"),
    most_ns: get("most_ns"),
  };
}

/** Rows of the table at one tolerance; quantities that do not change stand in the first alone. */
function tableRows(table, place) {
  const columns = { ...table.tolerances[0].columns, ...table.tolerances[place].columns };
  const keys = Object.keys(columns);
  const longest = keys.map((key) => columns[key]).find(Array.isArray);
  const rows = [];
  for (let i = 0; i < (longest ? longest.length : 1); ++i)
    rows.push(Object.fromEntries(keys.map((key) => [key, at(columns[key], i)])));
  return rows;
}

export function decode(raw) {
  const rows = [];
  for (let i = 0; i < raw.rows.count; ++i) rows.push(rowOf(raw, i));
  const tolerances = raw.table.tolerances.map((entry) => entry.tolerance);
  const own = raw.table.tolerances.find((entry) => entry.own);
  const corpora = [...new Set(raw.instances.map((instance) => instance.corpus))];
  const { kinds, at: judgedAt } = raw.judgements;
  return {
    ...raw,
    rows,
    corpora,
    tolerances,
    ownTolerance: own ? own.tolerance : null,
    /** Rows with what the program's judge says of them at a tolerance: {verdict, column, unclaimed,
     *  counted, row}. Columns are those of the table; `counted` rows are the denominator of shares. */
    judgedAt: (tolerance) => {
      const list = judgedAt[tolerances.indexOf(tolerance)];
      return rows.map((row) => ({ ...kinds[at(list, row.index)], row }));
    },
    tableRows: (tolerance) => tableRows(raw.table, tolerances.indexOf(tolerance)),
  };
}
