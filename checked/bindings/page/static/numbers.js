// SPDX-License-Identifier: MIT
// Exact numbers: fractions {n, d} of BigInts in lowest terms, d above zero, as the module `oplus` has them.

const gcd = (a, b) => b === 0n ? a : gcd(b, a % b);

function reduced(n, d) {
  const most = gcd(n < 0n ? -n : n, d);
  return {n: n / most, d: d / most};
}

export const integer = (value) => ({n: BigInt(value), d: 1n});
export const add = (a, b) => reduced(a.n * b.d + b.n * a.d, a.d * b.d);
export const multiply = (a, b) => reduced(a.n * b.n, a.d * b.d);
export const negative = ({n, d}) => ({n: -n, d});

export const addPoints = (a, b) => a.map((c, i) => add(c, b[i]));
export const middle = (a, b) => addPoints(a, b).map((c) => multiply(c, {n: 1n, d: 2n}));

/** A text "p/q" or a decimal that the core has taken or written, such as "-1.5e3". */
export function number(text) {
  const [over, under] = text.trim().split("/");
  if (under !== undefined) return reduced(BigInt(over), BigInt(under));
  const [digits, exponent = "0"] = over.toLowerCase().split("e"), [whole, decimals = ""] = digits.split(".");
  const n = BigInt((whole + decimals).replace("+", "") || 0), shift = Number(exponent) - decimals.length;
  return shift < 0 ? reduced(n, 10n ** BigInt(-shift)) : integer(n * 10n ** BigInt(shift));
}

/** As the core writes it: a decimal where that ends, else "p/q". */
export function written({n, d}) {
  if (d === 1n) return String(n);
  let decimals = 0, rest = d;
  for (const prime of [2n, 5n]) {
    let count = 0;
    for (; rest % prime === 0n; rest /= prime) ++count;
    decimals = Math.max(decimals, count);
  }
  if (rest !== 1n) return `${n}/${d}`;
  const digits = String((n < 0n ? -n : n) * 10n ** BigInt(decimals) / d).padStart(decimals + 1, "0");
  return `${n < 0n ? "-" : ""}${digits.slice(0, -decimals)}.${digits.slice(-decimals)}`;
}

/** For the eye. Throws for a number beyond all doubles. */
export function double({n, d}) {
  let value = Number(n) / Number(d);
  if (!Number.isFinite(value)) {
    const shift = BigInt(Math.max(0, Math.min(n.toString(2).length, d.toString(2).length) - 100));
    value = Number(n >> shift) / Number(d >> shift);
  }
  if (!Number.isFinite(value)) throw new RangeError("a number is beyond all doubles, and cannot be drawn");
  return value;
}

export const doubles = (point) => point.map(double);
export const writtenPoint = (point) => `(${point.map(written).join(", ")})`;
