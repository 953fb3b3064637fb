// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "properties/proofs/smt/query.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus::smt {

/// A vector of the unknowns, looked up inside `executed`.
using Vectors = std::function<TermVector(const Values&)>;

/// NAME as a direction; turned by π; their sum.
Vectors direction(const std::string& name);
Vectors opposite(const Vectors& v);
Vectors sum(const Vectors& u, const Vectors& v);

/// A vector to the left of v whose skew product with v contains no product of unknowns.
Vectors leftwards(const Vectors& v);

/// Near a vertex the interior is the sector of the directions between the edge that leaves it and the
/// reverse of the edge that enters it, counterclockwise; inside an edge, those to its left.
struct Corners {
  Vectors in;
  Vectors out;
};

/// The corner of the directions PREFIXin and PREFIXout, and what it is in a model.
Corners corner(const std::string& prefix = "");
Corner corner_in(const Model& model, const std::string& prefix = "");

Claim is_left(const Vectors& of, const Vectors& d);
Claim is_right(const Vectors& of, const Vectors& d);
Claim are_equal(const Vectors& u, const Vectors& v);
Claim are_parallel(const Vectors& u, const Vectors& v);

/// The code of the contracts (cyclic_order.hpp), executed.
Claim is_in_tangent_set(const Vectors& d, Summand of, const Corners& corner);
Claim is_a_reflex_vertex(const Corners& corner);

Claim is_in_sector(const Vectors& d, const Corners& corner);
Claim turns_back(const Corners& corner);

/// Whether one of the vectors points into both sectors; if any vector does, one of these does.
Claim one_is_in(const std::vector<Vectors>& candidates,
                const std::function<Claim(const Vectors&)>& is_in_both);

}  // namespace oplus::smt
