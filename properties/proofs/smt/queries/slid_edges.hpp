// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/slide/blocked_interval.hpp"
#include "properties/proofs/smt/values.hpp"

namespace oplus::smt {

/// A line c + t d, and the edges of P and of Q, which start in the origin.
struct SlidEdges {
  TermVector c;
  TermVector d;
  TermVector u;
  TermVector w;
  slide::Shift shift = slide::Shift::to_the_right;  ///< the argument of the code
};

/// The edges of P and Q in the coordinates that make their parallelogram the unit square.
struct Sides {
  std::string suffix;  ///< of ids
  TermVector u;
  TermVector w;
};

/// 0 < value < 1.
Formula is_inside_unit(const Term& value);

/// Whether t is in the interval that slide's code computes, and whether it finds one at all: the code,
/// executed.
Formula blocks(const SlidEdges& edges, const Term& t);
Formula blocks_somewhere(const SlidEdges& edges);

/// The same of known numbers by the code as it runs, in integers.
bool blocks_in_integers(const SlidEdges& edges, const Term& t);

/// Whether the edge of P and that of -Q + x cross properly, by definition; x shifted to the right of d
/// by very little, or not. Requires: known numbers.
bool cross_at(const SlidEdges& edges, const TermVector& x, slide::Shift shift);

}  // namespace oplus::smt
