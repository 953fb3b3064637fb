// SPDX-License-Identifier: MIT
#include "checked/operations/unbounded_sum.hpp"

#include "checked/operations/set_sum.hpp"
#include "reference/chains/frame.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/unbounded.hpp"

namespace oplus {

namespace {

/// Two summands that are not empty, as values of one type; `sum` is for bounded ones.
template <typename Set, typename Sum>
PlanarSet sum_in_frames(const Set& p, bool p_is_unbounded, const Set& q, bool q_is_unbounded,
                        Sum sum) {
  if (!p_is_unbounded && !q_is_unbounded) return sum(p, q);
  PlanarSet plane;
  plane.is_unbounded = true;
  if (p_is_unbounded && q_is_unbounded) return plane;
  Rational margin = extent(p_is_unbounded ? q : p) + 1;
  if (OPLUS_MUTANT("frames-are-too-near",
                   "the frame of an unbounded summand is not further away than the other is wide"))
    margin /= 4;
  return unframed(sum(framed(p, margin), framed(q, margin)));
}

}  // namespace

PlanarSet unbounded_sum(const Region& p, const Region& q, Boundary boundary, const SumOf& sum) {
  if (p.components.empty() || q.components.empty()) return {};
  return sum_in_frames(p, is_unbounded(p), q, is_unbounded(q),
                       [&](const Region& a, const Region& b) {
                         return sum(a, b,
                                    OPLUS_MUTANT("closed-sums-are-open",
                                                 "a closed sum of regions that may be unbounded is "
                                                 "that of their interiors")
                                        ? Boundary::open
                                        : boundary);
                       });
}

PlanarSet unbounded_sum(const PlanarSet& p, const PlanarSet& q, Boundary boundary,
                        const SumOf& sum) {
  if (is_empty(p) || is_empty(q)) return {};
  return sum_in_frames(
      p, p.is_unbounded, q, q.is_unbounded,
      [&](const PlanarSet& a, const PlanarSet& b) { return set_sum(a, b, boundary, sum); });
}

}  // namespace oplus
