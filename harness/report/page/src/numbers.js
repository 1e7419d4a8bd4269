// Numbers for readers, like the program prints them.

/** C's exponent has two digits at least: 1e-06. */
function exponent(text) {
  return text.replace(/e([+-])(\d)$/, "e$10$2");
}

/** A value in one of the table's formats: {:.0f}, {:.1f}, {:.2f}, {:#.3g}, {:.1e}. */
export function formatted(value, format) {
  if (value === null || value === undefined) return "-";
  if (value === 0) return "0";
  const [, kept, digits, kind] = format.match(/^\{:(#?)\.(\d)([feg])\}$/);
  if (kind === "f") return value.toFixed(+digits);
  if (kind === "e") return exponent(value.toExponential(+digits));
  const size = Math.floor(Math.log10(Math.abs(+value.toPrecision(+digits))));
  if (size < -4 || size >= +digits) return exponent(value.toExponential(+digits - 1));
  const text = value.toPrecision(+digits);
  return kept ? text : String(+text);
}

/** 1e-06 as a tolerance is printed. */
export function tolerance(value) {
  return value >= 1e-4 ? String(value) : exponent(value.toExponential());
}

/** A power of ten at an axis of residuals: 1e-06, also 1e-02. */
export function power(value) {
  return exponent(value.toExponential());
}

export function figure(value) {
  if (value === null || value === undefined) return "-";
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "inf");
  if (value === 0) return "0";
  return Math.abs(value) >= 0.01 && Math.abs(value) < 1e5 ? String(+value.toPrecision(4))
                                                          : exponent(value.toExponential(2));
}

/** A time with its unit: 32.7 us. */
export function duration(ns) {
  if (ns === null || ns === undefined) return "-";
  for (const [unit, size] of [["s", 1e9], ["ms", 1e6], ["us", 1e3]])
    if (ns >= size) return `${+(ns / size).toPrecision(3)} ${unit}`;
  return `${+ns.toPrecision(3)} ns`;
}

export function percent(share) {
  const value = 100 * share;
  return `${value > 0 && value < 1 ? value.toFixed(1) : value > 99 && value < 100 ? value.toFixed(1)
    : value.toFixed(0)} %`;
}

/** Ticks 1, 2, 5, 10, ... of a logarithmic axis; over many decades powers of ten alone. */
export function logTicks([from, to]) {
  const digits = Math.log10(to / from) < 3.2 ? [1, 2, 5] : [1];
  const ticks = [];
  for (let power = Math.floor(Math.log10(from)); 10 ** power <= to; ++power)
    for (const digit of digits) {
      const tick = +`${digit}e${power}`;
      if (tick >= from && tick <= to) ticks.push(tick);
    }
  return ticks;
}
