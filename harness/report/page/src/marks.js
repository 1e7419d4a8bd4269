// How each variant is marked in all charts: the look that the program gives it everywhere, and a letter,
// so that colour is never the only cue.

function letters(place) {
  const letter = String.fromCharCode(97 + (place % 26));
  return place < 26 ? letter : letters(Math.floor(place / 26) - 1) + letter;
}

export function marksOf(variants) {
  return variants.map(({ look }, place) => ({ look, letter: letters(place) }));
}
