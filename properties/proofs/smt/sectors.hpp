// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "properties/proofs/smt/query.hpp"

namespace oplus::smt {

/// A vector that is looked up inside `executed`.
using Vectors = std::function<TermVector()>;

/// NAME as a direction; turned by π; their sum.
Vectors direction(const Values& values, const std::string& name);
Vectors opposite(const Vectors& v);
Vectors sum(const Vectors& u, const Vectors& v);

/// A vector to the left of v, for which skew products with v need no product of unknowns.
Vectors leftwards(const Vectors& v);

/// Near a vertex the interior is the sector of the directions between the edge that leaves it and the
/// reverse of the edge that enters it, counterclockwise; inside an edge, those to its left.
struct Corners {
  Vectors in;
  Vectors out;
};

Formula is_left(const Vectors& of, const Vectors& d);
Formula is_right(const Vectors& of, const Vectors& d);
Formula are_equal(const Vectors& u, const Vectors& v);
Formula are_parallel(const Vectors& u, const Vectors& v);

/// The code of the contracts (cyclic_order.hpp), executed.
Formula is_in_tangent_set(const Vectors& d, Summand of, const Corners& corner);
Formula is_a_reflex_vertex(const Corners& corner);

Formula is_in_sector(const Vectors& d, const Corners& corner);
Formula turns_back(const Corners& corner);

/// Whether one of the vectors points into both: of them, one does if any does at all.
Formula one_is_in(const std::vector<Vectors>& candidates,
                  const std::function<Formula(const Vectors&)>& is_in_both);

}  // namespace oplus::smt
