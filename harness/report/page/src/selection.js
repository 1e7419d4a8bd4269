// What the reader chose to see, and the rows that belong to it.

/** The corpus on whose instances solvers differ most: sum over instances of p (1 - p), p solved. */
function mostTelling(run, tolerance) {
  const solved = new Map();
  for (const { column, row } of run.judgedAt(tolerance)) {
    if (column === "unsupported" || column === "not_run") continue;
    const [good, all] = solved.get(row.instance) ?? [0, 0];
    solved.set(row.instance, [good + (column === "success" || column === "trivial"), all + 1]);
  }
  const score = new Map(run.corpora.map((corpus) => [corpus, 0]));
  for (const [instance, [good, all]] of solved) {
    const { corpus } = run.instances[instance];
    score.set(corpus, score.get(corpus) + (good / all) * (1 - good / all));
  }
  return run.corpora.reduce((best, each) => (score.get(each) > score.get(best) ? each : best));
}

export class Selection {
  constructor(run) {
    this.run = run;
    this.tolerance = run.ownTolerance ?? 1e-6;
    this.corpus = mostTelling(run, this.tolerance);  // null: all
    this.hidden = new Set();                         // Variants.
    this.verdicts = new Set();                       // In the matrix; none means all.
    this.listeners = [];
    this.refresh();
  }

  onChange(listener) {
    this.listeners.push(listener);
  }

  change(values) {
    Object.assign(this, values);
    this.refresh();
    for (const listener of this.listeners) listener();
  }

  shown(variant) {
    return !this.hidden.has(variant);
  }

  /** Variants that are shown and have rows in the corpus, in the run's order. */
  variants() {
    return this.run.variants.map((_, i) => i).filter((i) => this.shown(i) && this.rowsOf.has(i));
  }

  title() {
    return this.corpus ?? "all corpora";
  }

  /** Rows of the corpus as judged at a tolerance, by variant; of hidden variants too. */
  rowsAt(tolerance) {
    const { run } = this;
    const rowsOf = new Map();
    for (const judged of run.judgedAt(tolerance)) {
      const { instance, variant } = judged.row;
      if (this.corpus !== null && run.instances[instance].corpus !== this.corpus) continue;
      if (!rowsOf.has(variant)) rowsOf.set(variant, []);
      rowsOf.get(variant).push(judged);
    }
    return rowsOf;
  }

  refresh() {
    this.rowsOf = this.rowsAt(this.tolerance);
    this.rows = [...this.rowsOf.values()].flat().sort((a, b) => a.row.index - b.row.index);
    this.instances = new Set(this.rows.map((each) => each.row.instance));
  }
}
