// Labels at the right ends of curves, moved apart so that none covers another, with a line to the end
// of each curve.

import { key, svg, text } from "./sheet.js";
import { shapeOf } from "./shapes.js";

const lineHeight = 14;

/** Heights for labels wanted at `wanted` (ascending), `lineHeight` apart, within [top, bottom]. */
function apart(wanted, top, bottom) {
  const heights = [];
  for (const y of wanted) heights.push(Math.max(y, (heights.at(-1) ?? top - lineHeight) + lineHeight));
  let limit = bottom;
  for (let i = heights.length - 1; i >= 0; --i) {
    heights[i] = Math.min(heights[i], limit);
    limit = heights[i] - lineHeight;
  }
  return heights;
}

/** `ends`: {y, mark, words} of each curve, in pixels of the sheet. */
export function endLabels(ends, x, top, bottom) {
  const sorted = [...ends].sort((a, b) => a.y - b.y);
  const heights = apart(sorted.map((end) => end.y), top, bottom);
  return svg("g", { "font-size": 11.5 }, ...sorted.map((end, i) => svg("g", {},
    svg("path", { d: `M${x},${end.y}L${x + 14},${heights[i]}`, fill: "none", stroke: "#999",
                  "stroke-width": 0.7 }),
    key(x + 18, heights[i], end.mark, shapeOf(end.mark.symbol, 36)),
    text(x + 46, heights[i] + 4, end.words))));
}

export function roomFor(count) {
  return count * lineHeight;
}
