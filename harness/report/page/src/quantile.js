// Quantiles as in harness/observed_quantile.h: always one of the values, so that they agree with the
// table to the last digit.

/** The least of the sorted values that at least the share p of them does not exceed. */
export function quantile(sorted, p) {
  if (sorted.length === 0) return null;
  return sorted[Math.max(Math.ceil(p * sorted.length), 1) - 1];
}

export function ascending(values) {
  return [...values].sort((a, b) => a - b);
}
