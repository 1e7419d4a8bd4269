// The matrix of verdicts: instance by solver. A letter says the verdict, the colour its column of the
// table; a cell opens all that is known of the row.

import { details } from "./details.js";
import { element, escaped } from "./dom.js";
import { sign, verdictSigns } from "./verdicts.js";

/** Judged rows by instance, then by variant. */
function byInstance(selection) {
  const grid = new Map();
  for (const judged of selection.rows) {
    const { instance, variant } = judged.row;
    if (!grid.has(instance)) grid.set(instance, new Map());
    grid.get(instance).set(variant, judged);
  }
  return grid;
}

function filters(selection, variants) {
  const counts = new Map();
  for (const { verdict, row } of selection.rows)
    if (variants.includes(row.variant)) counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
  const boxes = selection.run.verdicts.filter(({ name }) => counts.has(name))
    .map(({ name, column }) => element("label", { class: `chip c-${column}`,
                                                  title: verdictSigns[name][1] },
      element("input", {
        type: "checkbox", name: "verdict", value: name, checked: selection.verdicts.has(name),
        onchange: (event) => {
          const verdicts = new Set(selection.verdicts);
          event.target.checked ? verdicts.add(name) : verdicts.delete(name);
          selection.change({ verdicts });
        },
      }), element("b", {}, verdictSigns[name][0]), ` ${name} ${counts.get(name)}`));
  return [element("span", {}, "Only instances with: "), ...boxes];
}

function cell(judged, selection) {
  if (!judged) return '<td class="empty"></td>';
  const dim = selection.verdicts.size > 0 && !selection.verdicts.has(judged.verdict);
  return `<td class="c-${judged.column}${dim ? " dim" : ""}" data-row="${judged.row.index}" `
    + `tabindex="-1">${sign(judged)}</td>`;
}

function body(selection, grid, variants) {
  const { run } = selection;
  const out = [];
  let corpus = null, shown = 0;
  for (const [instance, cells] of grid) {
    const { name, n, corpus: of } = run.instances[instance];
    if (selection.verdicts.size > 0 &&
        !variants.some((v) => selection.verdicts.has(cells.get(v)?.verdict))) continue;
    if (of !== corpus)
      out.push(`<tr class="corpus"><th colspan="${variants.length + 1}" scope="rowgroup"><span>${
        escaped(of)}</span></th></tr>`);
    corpus = of;
    ++shown;
    out.push(`<tr><th scope="row" title="${escaped(name)}, n = ${n}">${
      escaped(name.slice(of.length + 1) || name)}</th>${
      variants.map((v) => cell(cells.get(v), selection)).join("")}</tr>`);
  }
  return { html: out.join(""), shown };
}

export function matrixSection(selection, marks) {
  const { run } = selection;
  const table = element("table", { class: "matrix", role: "grid" });
  const panel = element("aside", { class: "panel", "aria-live": "polite" },
    element("p", { class: "hint" }, "Choose a cell to see what happened there, and the command that "
      + "solves it again. Arrow keys move, Enter opens."));
  const readout = element("p", { class: "readout", "aria-live": "off" });
  const chips = element("div", { class: "chips" });
  const scroll = element("div", { class: "scroll tall" }, table);
  let judgedOf = new Map();

  const open = (td) => {
    table.querySelector(".chosen")?.classList.remove("chosen");
    td.classList.add("chosen");
    panel.replaceChildren(...details(run, judgedOf.get(+td.dataset.row)));
    panel.scrollTop = 0;
  };
  const tell = (td) => {
    const judged = judgedOf.get(+td.dataset.row);
    readout.textContent = `${run.instances[judged.row.instance].name}, ${
      run.variants[judged.row.variant].label}: ${judged.column === "trivial" ? "trivially " : ""}${
      judged.verdict}`;
  };
  const move = (td, dx, dy) => {
    let line = td.parentElement;
    const column = td.cellIndex + dx;
    do line = dy > 0 ? line.nextElementSibling : dy < 0 ? line.previousElementSibling : line;
    while (line && line.className === "corpus");
    const next = line?.cells[column];
    if (!next || !next.dataset.row) return;
    td.tabIndex = -1;
    next.tabIndex = 0;
    next.focus();
  };
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  table.addEventListener("click", (event) => {
    const td = event.target.closest("td[data-row]");
    if (td) open(td);
  });
  table.addEventListener("mouseover", (event) => {
    const td = event.target.closest("td[data-row]");
    if (td) tell(td);
  });
  table.addEventListener("focusin", (event) => {
    if (event.target.dataset.row) tell(event.target);
  });
  table.addEventListener("keydown", (event) => {
    const td = event.target;
    if (!td.dataset.row) return;
    if (event.key === "Enter" || event.key === " ") open(td);
    else if (event.key in steps) move(td, ...steps[event.key]);
    else return;
    event.preventDefault();
  });

  const section = element("section", { id: "matrix" },
    element("h2", {}, "What happened: verdicts by instance and solver"),
    element("p", { class: "explanation" }, "A letter is a verdict, a colour its column in the table; ",
            element("b", {}, "t"), " is solved where z = 0 is a solution too, a star marks an answer "
            + "that passes although its solver claims a failure. The rest is explained ",
            element("a", { href: "#legend" }, "below"), "."),
    chips, readout,
    element("div", { class: "beside" }, scroll, panel));

  const redraw = () => {
    const variants = selection.variants();
    const grid = byInstance(selection);
    judgedOf = new Map(selection.rows.map((judged) => [judged.row.index, judged]));
    chips.replaceChildren(...filters(selection, variants));
    const heads = variants.map((v) => `<th scope="col" title="${escaped(run.variants[v].label)}"><span>${
      `<b>${escaped(marks[v].letter)}</b> ${escaped(run.variants[v].label)}`}</span></th>`).join("");
    const { html, shown } = body(selection, grid, variants);
    table.innerHTML = `<thead><tr><th scope="col" class="corner">${shown} of ${grid.size} instances</th>${
      heads}</tr></thead><tbody>${html}</tbody>`;
    const first = table.querySelector("td[data-row]");
    if (first) first.tabIndex = 0;
    readout.textContent = "\u00a0";
  };
  return { section, redraw };
}
