// What the reader can choose for the whole page: corpus, tolerance, and which solvers take part.

import { element, select } from "./dom.js";
import { key } from "./figure.js";
import { tolerance } from "./numbers.js";
import { svg } from "./svg.js";

function corpusChoice(selection) {
  const { run } = selection;
  const size = new Map();
  for (const { corpus } of run.instances) size.set(corpus, (size.get(corpus) ?? 0) + 1);
  const choices = run.corpora.map((corpus, i) => [String(i), `${corpus} (${size.get(corpus)})`]);
  if (choices.length > 1) choices.push(["all", `all corpora (${run.instances.length})`]);
  return select("Corpus or scene", "corpus", choices,
                selection.corpus === null ? "all" : String(run.corpora.indexOf(selection.corpus)),
                (value) => selection.change({ corpus: value === "all" ? null : run.corpora[+value] }));
}

function toleranceChoice(selection) {
  const { run } = selection;
  return select("Solved means a residual of at most", "tolerance",
    run.tolerances.map((each) => [String(each), tolerance(each) +
      (each === run.ownTolerance ? " (as run)" : "")]),
    String(selection.tolerance), (value) => selection.change({ tolerance: +value }));
}

export function controls(selection, marks) {
  const { run } = selection;
  const boxes = run.variants.map((variant, i) => {
    const box = element("input", {
      type: "checkbox", name: "solver", value: String(i), checked: true,
      onchange: () => {
        const hidden = new Set(selection.hidden);
        box.checked ? hidden.delete(i) : hidden.add(i);
        selection.change({ hidden });
      },
    });
    return box;
  });
  const hide = (hidden) => {
    boxes.forEach((box, i) => { box.checked = !hidden.has(i); });
    selection.change({ hidden });
  };
  const indices = run.variants.map((_, i) => i);
  const button = (words, hidden) =>
    element("button", { type: "button", onclick: () => hide(hidden()) }, words);
  const legend = element("fieldset", { class: "solvers" }, element("legend", {}, "Solvers shown"),
    element("div", { class: "buttons" },
      button("all", () => new Set()),
      button("none", () => new Set(indices)),
      button("others", () => new Set(indices.filter((i) => selection.shown(i))))),
    ...run.variants.map((variant, i) => element("label", { class: "solver", title: variant.label },
      boxes[i],
      svg("svg", { width: 26, height: 12, "aria-hidden": "true" },
          key(0, 6, { look: marks[i].look, line: true })),
      element("b", {}, marks[i].letter), element("span", {}, variant.label))));
  return element("aside", { class: "controls" },
    element("nav", {}, ...[["#matrix", "Verdicts"], ["#table", "Table"], ["#plane", "Speed and accuracy"],
      ["#profile", "Profile"], ["#cumulative", "Within a time"], ["#accuracy", "Accuracy in time"],
      ["#legend", "Legend"], ["#run", "Run"],
      ...(document.getElementById("pictures") ? [["#pictures", "Pictures"]] : [])]
      .map(([href, words]) => element("a", { href }, words))),
    corpusChoice(selection), toleranceChoice(selection), legend);
}
