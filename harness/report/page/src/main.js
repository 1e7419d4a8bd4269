// The page of a run: reads the data that stand in it, and puts the sections together.

import { about, notes } from "./about.js";
import { controls } from "./controls.js";
import { accuracySection, withinTimeSection } from "./cumulative.js";
import { decode } from "./data.js";
import { element } from "./dom.js";
import { marksOf } from "./marks.js";
import { matrixSection } from "./matrix.js";
import { planeSection } from "./plane.js";
import { profileSection } from "./profiles.js";
import { Selection } from "./selection.js";
import { tableSection } from "./tables.js";

function heading(run) {
  const commit = run.environments[0]?.commit;
  const facts = [
    `${run.instances.length} instances in ${run.corpora.length} corpora`,
    `${run.variants.length} solvers`, `${run.rows.length} rows`,
    ...(commit ? [`commit ${String(commit).slice(0, 12)}`] : []),
  ];
  return element("header", {}, element("h1", {}, `lcpbench: ${run.name}`),
                 element("p", {}, `LCP solvers, find z with w = M z + q, w >= 0, z >= 0, w'z = 0. ${
                   facts.join(", ")}.`), notes(run));
}

function build() {
  const run = decode(JSON.parse(document.getElementById("data").textContent));
  const marks = marksOf(run.variants);
  const selection = new Selection(run);
  const main = element("main");
  const parts = [matrixSection(selection, marks), tableSection(selection, marks),
                 planeSection(selection, marks, main), profileSection(selection, marks, main),
                 withinTimeSection(selection, marks, main), accuracySection(selection, marks, main)];
  main.append(...parts.map((part) => part.section), ...about(run));
  const pictures = document.getElementById("pictures");
  const side = controls(selection, marks);
  document.getElementById("report").replaceChildren(heading(run),
    element("div", { class: "page" }, side, main));
  if (pictures) main.append(pictures);

  const redraw = () => parts.forEach((part) => part.redraw());
  selection.onChange(redraw);
  let width = 0;
  new ResizeObserver(() => {
    if (Math.abs(main.offsetWidth - width) < 8) return;
    width = main.offsetWidth;
    for (const part of parts.slice(2)) part.redraw();
  }).observe(main);
  redraw();
}

build();
