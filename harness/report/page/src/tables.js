// The tables: what `lcpbench table` counts at the tolerance that is shown. The numbers come from the
// program; nothing is counted here.

import { element } from "./dom.js";
import { formatted, tolerance } from "./numbers.js";

function meanOfCorpus(rows, key) {
  const found = rows.find((row) => row[key] !== null);
  return found ? found[key].toFixed(1) : null;
}

function block(corpus, rows, columns, variantPlace, marks) {
  const most = Math.max(...rows.map((row) => row.instances));
  const contacts = meanOfCorpus(rows, "contacts"), active = meanOfCorpus(rows, "active");
  const caption = `${corpus}: ${most} instance${most === 1 ? "" : "s"}${
    contacts ? `, ${contacts} contacts` : ""}${active ? `, ${active} active` : ""}`;
  return element("table", { class: "counts" },
    element("caption", {}, caption),
    element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "solver"),
      ...columns.map((column) => element("th", { scope: "col", title: column.meaning },
                                         column.heading)))),
    element("tbody", {}, ...rows.map((row) => element("tr", {
      "data-solver": row.solver, "data-corpus": row.corpus, "data-start": row.start },
      element("th", { scope: "row" },
              element("b", {}, marks[variantPlace(row)].letter), ` ${row.label}`),
      ...columns.map((column) => element("td", {
        "data-key": column.key, "data-value": JSON.stringify(row[column.key]) },
        formatted(row[column.key], column.number)))))));
}

export function tableSection(selection, marks) {
  const { run } = selection;
  const place = new Map(run.variants.map((v, i) => [`${v.solver}\n${v.start}`, i]));
  const variantPlace = (row) => place.get(`${row.solver}\n${row.start}`);
  const blocks = element("div", { class: "scroll", tabindex: 0 });
  const meanings = element("dl", { class: "meanings" });
  const note = element("p", { class: "explanation" });
  const section = element("section", { id: "table" }, element("h2", {}, "Table"), note, blocks, meanings);
  const redraw = () => {
    const all = run.tableRows(selection.tolerance);
    const rows = all.filter((row) => (selection.corpus === null || row.corpus === selection.corpus) &&
                                     selection.shown(variantPlace(row)));
    const columns = run.table.columns.filter((column) =>
      !column.only_if_any || all.some((row) => (row[column.key] ?? 0) !== 0));
    const corpora = [...new Set(rows.map((row) => row.corpus))];
    blocks.replaceChildren(...corpora.map((corpus) =>
      block(corpus, rows.filter((row) => row.corpus === corpus), columns, variantPlace, marks)));
    meanings.replaceChildren(...columns.flatMap((column) =>
      [element("dt", {}, column.heading), element("dd", {}, column.meaning)]));
    const jobs = all[0]?.jobs ?? 1;
    note.textContent = `Solved means a natural residual of at most ${tolerance(selection.tolerance)}${
      selection.tolerance === run.ownTolerance ? ", the tolerance of the run" : ", judged anew"}.${
      jobs > 1 ? ` ${jobs} jobs ran at the same time: times are disturbed.` : ""}`;
  };
  return { section, redraw };
}
