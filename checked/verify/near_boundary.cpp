// SPDX-License-Identifier: MIT
#include "checked/verify/near_boundary.hpp"

#include <algorithm>
#include <utility>

#include "checked/operations/set_sum.hpp"
#include "checked/verify/closeness.hpp"
#include "checked/verify/overlay.hpp"
#include "checked/verify/verify.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

namespace {

/// At most the number divided by √2, and less by a 2^64th of it at most.
Rational divided_by_root_of_two(const Rational& value) {
  const mpz_class& p = value.get_num();
  const mpz_class& q = value.get_den();
  const mpz_class scale = mpz_class(1) << 66;
  const mpz_class square = p * p * scale * scale / 2;
  Rational result(mpz_class(sqrt(square)), mpz_class(q * scale));
  result.canonicalize();
  return result;
}

/// The boundary of a set, the set to the left.
using Boundaries = std::vector<Segment>;

PlanarSet set_of(Boundaries boundary) {
  return canonical_sum(BoundaryFeatures{std::move(boundary), {}, {}});
}

/// The complement in a frame.
Boundaries complement_in(const Chain& frame, const Boundaries& boundary) {
  Boundaries result = edges(frame);
  for (const Segment& e : boundary) result.push_back(reversed(e));
  return result;
}

Chain frame_around(const Boundaries& a, const Boundaries& b, const Rational& margin) {
  Boundaries both = a;
  both.insert(both.end(), b.begin(), b.end());
  return box_around(both).enlarged(margin).corners();
}

/// Whether a set, together with edges and points, grown by a square, contains another one.
bool contains_when_grown(const Boundaries& set, const PlanarSet& features, const Boundaries& other,
                         const Rational& half) {
  const Region square = polygon({{-half, -half}, {half, -half}, {half, half}, {-half, half}});
  PlanarSet all = set_of(set);
  all.dangling_edges = features.dangling_edges;
  all.isolated_vertices = features.isolated_vertices;
  const PlanarSet grown = set_sum(all, canonical_sum(square), Boundary::closed, sum_by_definition);
  const Overlay overlay(given(set_of(other)), grown);
  return std::ranges::none_of(overlay.differences(),
                              [](const Overlay::Difference& d) { return d.reason.in_given; });
}

}  // namespace

bool differs_near_only(const PlanarSet& right, const ClaimedSum& given,
                       const std::vector<Segment>& boundary_of_given, const Rational& distance) {
  const Rational half = divided_by_root_of_two(distance);
  if (sgn(half) == 0) return false;
  const Overlay of_given(given, {});
  const Overlay of_right(oplus::given(right), {});
  const Boundaries a = of_right.boundary_of_given();
  const Boundaries b = of_given.boundary_of_given();
  if (!a.empty() || !b.empty()) {
    const Chain frame = frame_around(a, b, 4 * distance);
    if (!contains_when_grown(a, {}, b, half) ||
        !contains_when_grown(complement_in(frame, a), right, complement_in(frame, b), half))
      return false;
  }

  const SegmentTree boundary(boundary_of_given);
  std::vector<Segment> inside;
  for (const Segment& s : right.dangling_edges)
    for (const Segment& piece : cut_where_met(s, boundary))
      if (of_given.locate(midpoint(piece.source, piece.target)).of_given == Location::inside)
        inside.push_back(piece);
  for (const Point& p : right.isolated_vertices)
    if (of_given.locate(p).of_given == Location::inside) inside.push_back({p, p});
  return is_within(inside, boundary, distance * distance);
}

}  // namespace oplus
