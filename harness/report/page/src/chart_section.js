// The frame of every chart: heading, its own choices, the drawing, the numbers behind it, saving.

import { element } from "./dom.js";
import { drawFigure } from "./figure.js";
import { saveButton } from "./svg.js";

const narrowest = 560;
const widest = 1120;

/**
 * A section whose chart is drawn anew when the selection, its choices or the width change.
 * `draw(width)` returns {figure, numbers}: what is drawn (figure.js) and a table of what it shows, or
 * {nothing}: why there is no drawing.
 */
export function chartSection({ id, heading, explanation, choices = [], draw, selection, widths }) {
  const place = element("div", { class: "drawing" });
  const behind = element("div", { class: "scroll", tabindex: 0 });
  let drawing = null;
  const name = () => `${selection.run.name}-${id}-${selection.title()}`.replace(/[^\w.+-]+/g, "-");
  const section = element("section", { id, class: "chart", "data-chart": id },
    element("h2", {}, heading),
    element("p", { class: "explanation" }, explanation),
    element("div", { class: "choices" }, ...choices, saveButton(name, () => drawing)),
    place,
    element("details", { class: "numbers" }, element("summary", {}, "The numbers of this chart"),
            behind));
  const redraw = () => {
    const available = widths.offsetWidth || 1000;
    const drawn = draw(Math.max(narrowest, Math.min(widest, available)));
    drawing = drawn.figure ? drawFigure(drawn.figure) : null;
    place.replaceChildren(drawing ?? element("p", { class: "nothing" }, drawn.nothing));
    section.querySelector(".save").disabled = !drawing;
    behind.replaceChildren(drawn.numbers ?? "");
  };
  return { section, redraw };
}

/** A table of numbers: heads, and rows of {attributes, cells}. */
export function numbersTable(heads, rows) {
  return element("table", {},
    element("thead", {}, element("tr", {}, ...heads.map((head) => element("th", {}, head)))),
    element("tbody", {}, ...rows.map(({ attributes, cells }) => element("tr", attributes,
      ...cells.map((cell, i) => element(i === 0 ? "th" : "td", {}, String(cell)))))));
}
