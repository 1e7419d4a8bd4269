// Symbols by name, as paths.

import { symbol, symbolCircle, symbolCross, symbolDiamond, symbolSquare, symbolStar, symbolTriangle,
         symbolWye } from "d3";

export const shapes = {
  circle: symbolCircle, cross: symbolCross, diamond: symbolDiamond, square: symbolSquare,
  star: symbolStar, triangle: symbolTriangle, wye: symbolWye,
};

/** The path of a symbol with this area, px^2. */
export function shapeOf(name, area) {
  return symbol(shapes[name], area)();
}
