// SPDX-License-Identifier: GPL-3.0-or-later
// What the extracted programs use of Zarith's functions in C, for js_of_ocaml, over BigInt. An integer that fits into 32
// bits is a number, as OCaml's integers are there; no other one is. In a browser this file has to be believed.

//Provides: ml_z_of_big const
function ml_z_of_big(n) { return BigInt.asIntN(32, n) === n ? Number(n) : n; }

//Provides: ml_z_init const
function ml_z_init() { return 0; }

//Provides: ml_z_to_int
//Requires: caml_raise_constant, caml_named_value
function ml_z_to_int(n) { return typeof n === "number" ? n : caml_raise_constant(caml_named_value("ml_z_overflow")); }

// Signs and order: JavaScript compares numbers and BigInts by value.

//Provides: ml_z_compare const
function ml_z_compare(a, b) { return (a > b) - (a < b); }
//Provides: ml_z_equal const
function ml_z_equal(a, b) { return a === b ? 1 : 0; }
//Provides: ml_z_sign const
function ml_z_sign(a) { return (a > 0) - (a < 0); }

// Sums and products

//Provides: ml_z_neg const
//Requires: ml_z_of_big
function ml_z_neg(a) { return ml_z_of_big(-BigInt(a)); }
//Provides: ml_z_abs const
//Requires: ml_z_neg
function ml_z_abs(a) { return a < 0 ? ml_z_neg(a) : a; }
//Provides: ml_z_add const
//Requires: ml_z_of_big
function ml_z_add(a, b) { return ml_z_of_big(BigInt(a) + BigInt(b)); }
//Provides: ml_z_sub const
//Requires: ml_z_of_big
function ml_z_sub(a, b) { return ml_z_of_big(BigInt(a) - BigInt(b)); }
//Provides: ml_z_succ const
//Requires: ml_z_add
function ml_z_succ(a) { return ml_z_add(a, 1); }
//Provides: ml_z_pred const
//Requires: ml_z_sub
function ml_z_pred(a) { return ml_z_sub(a, 1); }
//Provides: ml_z_mul const
//Requires: ml_z_of_big
function ml_z_mul(a, b) { return ml_z_of_big(BigInt(a) * BigInt(b)); }
// Of numbers. The product as a double is exact where it fits.
//Provides: ml_z_mul_overflows const
function ml_z_mul_overflows(a, b) { return a * b === (a * b | 0) ? 0 : 1; }
//Provides: ml_z_pow
//Requires: ml_z_of_big, caml_invalid_argument
function ml_z_pow(a, n) {
  if (n < 0) caml_invalid_argument("Z.pow: exponent must be nonnegative");
  var power = BigInt(1);
  for (a = BigInt(a); n > 0; n >>= 1) {
    if (n & 1) power *= a;
    a *= a;
  }
  return ml_z_of_big(power);
}

// Quotients: rounded to zero with a remainder of a's sign, up, down, and of what is divisible.

//Provides: ml_z_div_rem
//Requires: ml_z_of_big, caml_raise_zero_divide
function ml_z_div_rem(a, b) {
  if (b === 0) caml_raise_zero_divide();
  a = BigInt(a);
  b = BigInt(b);
  return [0, ml_z_of_big(a / b), ml_z_of_big(a % b)];
}
//Provides: ml_z_rem
//Requires: ml_z_div_rem
function ml_z_rem(a, b) { return ml_z_div_rem(a, b)[2]; }
//Provides: ml_z_fdiv
//Requires: ml_z_div_rem, ml_z_sub
function ml_z_fdiv(a, b) {
  var both = ml_z_div_rem(a, b);
  return both[2] !== 0 && a < 0 !== b < 0 ? ml_z_sub(both[1], 1) : both[1];
}
//Provides: ml_z_cdiv
//Requires: ml_z_div_rem, ml_z_add
function ml_z_cdiv(a, b) {
  var both = ml_z_div_rem(a, b);
  return both[2] !== 0 && a < 0 === b < 0 ? ml_z_add(both[1], 1) : both[1];
}
//Provides: ml_z_divexact
//Requires: ml_z_div_rem
function ml_z_divexact(a, b) { return ml_z_div_rem(a, b)[1]; }
// Euclid's algorithm.
//Provides: ml_z_gcd const
//Requires: ml_z_abs, ml_z_of_big
function ml_z_gcd(a, b) {
  var rest;
  a = ml_z_abs(a);
  b = ml_z_abs(b);
  if (typeof a !== typeof b) {
    a = BigInt(a);
    b = BigInt(b);
  }
  while (b != 0) {
    rest = a % b;
    a = b;
    b = rest;
    if (typeof a === "bigint" && a <= Number.MAX_SAFE_INTEGER && b <= Number.MAX_SAFE_INTEGER) {
      a = Number(a);
      b = Number(b);
    }
  }
  return ml_z_of_big(BigInt(a));
}

// Texts: decimals only, with a digit at least.

//Provides: ml_z_format
//Requires: caml_jsstring_of_string, caml_string_of_jsstring, caml_invalid_argument
function ml_z_format(format, a) {
  if (caml_jsstring_of_string(format) !== "%d") caml_invalid_argument("Z.format: format is not %d");
  return caml_string_of_jsstring(String(a));
}
//Provides: ml_z_of_substring_base
//Requires: ml_z_of_big, caml_jsstring_of_string, caml_invalid_argument
function ml_z_of_substring_base(base, text, start, length) {
  var digits = caml_jsstring_of_string(text).substr(start, length);
  if (base !== 0 || !/^[-+]?[0-9]+$/.test(digits)) caml_invalid_argument("Z.of_substring_base: invalid digit");
  return ml_z_of_big(BigInt(digits));
}
