// How each solver looks in all charts: a letter, a colour (Okabe and Ito's), a symbol and a dash, so
// that colour is never the only cue. Settings of one method share its colour.

const colours = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00", "#56B4E9"];
const dashes = ["none", "6,3", "2,2", "8,3,2,3", "1,3", "12,3"];
const symbols = ["circle", "square", "triangle", "diamond", "cross", "star", "wye"];

function letters(place) {
  const letter = String.fromCharCode(97 + (place % 26));
  return place < 26 ? letter : letters(Math.floor(place / 26) - 1) + letter;
}

export function marksOf(variants) {
  const colourOfMethod = new Map();
  const usesOfColour = new Map();
  return variants.map((variant, place) => {
    if (!colourOfMethod.has(variant.row))
      colourOfMethod.set(variant.row, colours[colourOfMethod.size % colours.length]);
    const colour = colourOfMethod.get(variant.row);
    const use = usesOfColour.get(colour) ?? 0;
    usesOfColour.set(colour, use + 1);
    return {
      letter: letters(place),
      colour,
      dash: dashes[use % dashes.length],
      symbol: symbols[use % symbols.length],
    };
  });
}
