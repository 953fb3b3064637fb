// SPDX-License-Identifier: MIT
#include "checked/operations/operations.hpp"

#include "checked/operations/complement.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

namespace {

/// The closure of the interior of a closed set.
MinkowskiSum regularized(MinkowskiSum set) {
  set.dangling_edges.clear();
  set.isolated_vertices.clear();
  return set;
}

}  // namespace

MinkowskiSum no_fit(const Region& p, const Region& q, const SumOf& sum) {
  const bool is_not_turned = OPLUS_MUTANT(
      "no-fit-without-a-turn", "the no-fit polygon is the sum of P and Q, not of P and -Q");
  return unbounded_sum(p, is_not_turned ? q : reflected(q), Boundary::open, sum);
}

MinkowskiSum inner_fit(const Region& p, const Region& q, const SumOf& sum) {
  return complement(no_fit(complement(p), q, sum));
}

MinkowskiSum eroded(const Region& p, const Region& q, const SumOf& sum) {
  return regularized(inner_fit(p, q, sum));
}

MinkowskiSum opened(const Region& p, const Region& q, const SumOf& sum) {
  MinkowskiSum places = inner_fit(p, q, sum);
  if (OPLUS_MUTANT("openings-lose-exact-fits", "the opening lacks the copies of Q that just fit"))
    places = regularized(places);
  return unbounded_sum(places, canonical_sum(q), Boundary::closed, sum);
}

MinkowskiSum closed(const Region& p, const Region& q, const SumOf& sum) {
  const MinkowskiSum dilated = unbounded_sum(p, q, Boundary::closed, sum);
  if (OPLUS_MUTANT("closing-does-not-erode", "the closing is the sum")) return dilated;
  return eroded(region_of(dilated), q, sum);
}

const std::vector<Operation>& operations() {
  static const std::vector<Operation> all = {
      {"nfp", "where Q, moved, overlaps P: the no-fit polygon", true, no_fit},
      {"ifp", "where Q, moved, is inside P: the inner-fit polygon", false, inner_fit},
      {"erode", "the inner-fit polygon without edges and points", false, eroded},
      {"open", "all copies of Q inside P", false, opened},
      {"close", "the sum of P and Q, eroded by Q", false, closed}};
  return all;
}

}  // namespace oplus
