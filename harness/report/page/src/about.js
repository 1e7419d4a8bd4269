// What was run, on what, and what counts as what.

import { element } from "./dom.js";
import { columnMeanings, verdictSigns } from "./verdicts.js";

function words(value) {
  if (value === null) return "unknown";
  if (Array.isArray(value)) return value.map(words).join(", ") || "none";
  if (typeof value === "object")
    return Object.entries(value).map(([key, each]) => `${key} ${words(each)}`).join(", ");
  return String(value);
}

function listOf(object) {
  return element("dl", {}, ...Object.entries(object).flatMap(([key, value]) =>
    [element("dt", {}, key.replace(/_/g, " ")), element("dd", {}, words(value))]));
}

export function notes(run) {
  if (run.notes.length === 0) return null;
  return element("div", { class: "notes", role: "note" }, element("b", {}, "Mind: "),
    element("ul", {}, ...run.notes.map((note) => element("li", {}, note))));
}

function legend(run) {
  return element("section", { id: "legend" }, element("h2", {}, "What counts as what"),
    element("p", {}, "A solver claims, the judge decides: it computes w = M z + q anew with 113 bits "
      + "and takes an answer as solved when its natural residual max |min(z/s_z, w/s_w)| is at most "
      + "the tolerance. Other tolerances are judged from the stored residuals; a solver is not run "
      + "again for them. A failure is a row with its time to failure. Ratios and shares take no solver "
      + "to task for what it does not support or was not run on."),
    element("div", { class: "columns" },
      element("table", { class: "legend" }, element("caption", {}, "Verdicts"),
        ...run.verdicts.map(({ name, column }) => element("tr", {},
          element("td", { class: `c-${column}` }, verdictSigns[name][0]), element("th", {}, name),
          element("td", {}, verdictSigns[name][1])))),
      element("table", { class: "legend" }, element("caption", {}, "Colours: columns of the table"),
        ...columnMeanings.map(([column, meaning]) => element("tr", {},
          element("td", { class: `c-${column}` }, "\u00a0"), element("td", {}, meaning))))),
    element("p", {}, "Times are medians of repetitions of one solve, in a worker process, with judging "
      + "and reading outside the clock. Medians and quartiles are always one of the values. Residuals "
      + "other than the natural residual and that of z = 0 are kept here with four digits; rows.jsonl "
      + "has all."));
}

export function about(run) {
  return [
    legend(run),
    element("section", { id: "run" }, element("h2", {}, "Run and environment"),
      element("div", { class: "columns" },
        element("div", {}, element("h3", {}, "What was asked for (run.json)"),
                run.settings ? listOf(run.settings) : element("p", {}, "Not stored in this directory.")),
        element("div", {}, ...(run.environments.length ? run.environments.flatMap((each) =>
          [element("h3", {}, `Environment ${each.id ?? ""}`), listOf(each)])
          : [element("h3", {}, "Environment"), element("p", {}, "Not stored in this directory.")])))),
  ];
}
