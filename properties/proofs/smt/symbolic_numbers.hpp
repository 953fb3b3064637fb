// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/slide/integer_vector.hpp"
#include "properties/proofs/smt/values.hpp"

namespace oplus::smt {

/// Numbers for slide's code, which is a template over them.
struct SymbolicNumbers {
  using Value = Term;
  using Product = Term;
};

inline slide::IntegerVector<SymbolicNumbers> slide_vector(const TermVector& v) {
  return {v.x, v.y};
}

}  // namespace oplus::smt

/// They need no doubles beside them.
template <>
inline constexpr bool oplus::slide::is_small<oplus::smt::SymbolicNumbers> = true;
