// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/leading_edge.hpp"

#include <gtest/gtest.h>

#include "checked/slide/blocked_interval.hpp"
#include "tests/checked/slide/exact_values.hpp"

namespace oplus::slide {
namespace {

using Integer = AnyNumbers::Value;
using Vector = IntegerVector<AnyNumbers>;
using Edge = IntegerSegment<AnyNumbers>;

/// Short, long or far out of the range of doubles.
Integer number(Random& random) {
  const unsigned bits = std::array{3U, 60U, 3000U}[uniform(random, 0, 2)];
  const Integer odd = value<AnyNumbers>(odd_number(random, bits));
  return uniform(random, 0, 1) == 0 ? odd : Integer(-odd);
}

Vector vector(Random& random) { return {number(random), number(random)}; }

using Place = Fraction<AnyNumbers>;

/// From 0 to 1, about as near to an end as numbers can be, or anywhere.
Place place(Random& random) {
  Integer n =
      value<AnyNumbers>(odd_number(random, std::array{1U, 9U, 2900U}[uniform(random, 0, 2)]));
  const Integer d =
      n + value<AnyNumbers>(odd_number(random, std::array{9U, 3000U}[uniform(random, 0, 1)]));
  if (uniform(random, 0, 1) == 0) n = d - n;
  return {n, d};
}

/// A vertex, of which it is known whether it is one of an edge, and which.
struct Vertex {
  Vector at;
  int of_edge;  ///< 0 for the source, 1 for the target, else 2

  static Vertex any(Random& random, const Edge& e) {
    const int end = uniform(random, 0, 3);
    if (end == 0) return {e.source, 0};
    if (end == 1) return {e.source + e.direction, 1};
    // Beside the source, or anywhere.
    return {end == 2 ? e.source + Vector{uniform(random, -1, 1), 1} : vector(random), 2};
  }
  std::array<LeadingVector, 2> from(const Edge& e) const {
    const LeadingEdge edge = LeadingEdge::of(e);
    return {LeadingVector::difference(NearVector::of(at), edge.source, of_edge == 0),
            LeadingVector::difference(NearVector::of(at), edge.target, of_edge == 1)};
  }
};

TEST(LeadingEdge, is_beyond_a_side_only_where_no_place_is_inside) {
  Random random(1);
  std::size_t beyond = 0, outside = 0;
  for (int i = 0; i < 4000; ++i) {
    const Edge e{vector(random), vector(random)}, f{vector(random), vector(random)};
    const Vertex p = Vertex::any(random, e), q = Vertex::any(random, f);
    const bool along_e = i % 4 == 0 && p.of_edge == 0;
    const Edge segment{p.at + q.at, along_e ? e.direction : vector(random)};
    Place from = place(random), to = place(random);
    if (to < from) std::swap(from, to);
    const auto leading = [&](const Place& t) -> LeadingPlace {
      const NearVector d = NearVector::of(segment.direction);
      if (i % 2 == 0) {
        const NearVector along = near_number(t.numerator()) / near_number(t.denominator()) * d;
        return {p.from(e), q.from(f), LeadingVector::of(along)};
      }
      // Less the segment's target, for which its edge is taken to be of P.
      const NearVector along =
          near_number(Integer(t.numerator() - t.denominator())) / near_number(t.denominator()) * d;
      const Vertex target{p.at + segment.direction, along_e ? 1 : 2};
      return {target.from(e), q.from(f), LeadingVector::of(along)};
    };
    const bool is_beyond = certainly_beyond_a_side(std::array{leading(from), leading(to)},
                                                   {NearVector::of(e.direction), along_e},
                                                   {NearVector::of(f.direction), false});
    const auto blocked = blocked_interval(segment, e, f, Shift::none);
    const bool is_inside = blocked && blocked->from < to && from < blocked->to;
    EXPECT_FALSE(is_beyond && is_inside) << i;
    beyond += is_beyond;
    outside += !is_inside;
  }
  EXPECT_GT(100 * beyond, 60 * outside) << beyond << " of " << outside;
}

TEST(LeadingBox, is_beyond_a_side_only_where_no_place_is_inside_with_an_edge_in_the_box) {
  Random random(3);
  std::size_t beyond = 0, outside = 0;
  for (int i = 0; i < 4000; ++i) {
    // Vertices that are near each other, or anywhere; the segment begins at one of them, or does not.
    std::array<Vector, 3> in_box{vector(random), {}, {}};
    for (std::size_t k = 1; k < in_box.size(); ++k)
      in_box[k] = i % 2 == 0 ? in_box[0] + Vector{uniform(random, -9, 9), uniform(random, -9, 9)}
                             : vector(random);
    const Edge f{vector(random), vector(random)};
    const Vector p = i % 3 == 0   ? in_box[1]
                     : i % 3 == 1 ? in_box[0] + Vector{20, 1}
                                  : vector(random);
    const Vertex q = Vertex::any(random, f);
    const bool along_f = i % 4 == 0 && q.of_edge == 0;
    const Edge segment{p + q.at, along_f ? f.direction : vector(random)};
    Place from = place(random), to = place(random);
    if (to < from) std::swap(from, to);
    const auto leading = [&](const Place& t) -> LeadingPlaceByBox {
      const NearVector along = near_number(t.numerator()) / near_number(t.denominator()) *
                               NearVector::of(segment.direction);
      return {NearVector::of(p), q.from(f), LeadingVector::of(along)};
    };
    LeadingBox box = LeadingBox::of(NearVector::of(in_box[0]));
    for (const Vector& v : in_box) box = around(box, LeadingBox::of(NearVector::of(v)));
    const bool is_beyond = certainly_beyond_a_side(std::array{leading(from), leading(to)}, box,
                                                   {NearVector::of(f.direction), along_f});
    bool is_inside = false;
    for (std::size_t k = 0; k < in_box.size(); ++k) {
      const Vector& source = in_box[k];
      const Edge e{source, in_box[(k + 1) % in_box.size()] - source};
      const auto blocked = blocked_interval(segment, e, f, Shift::none);
      is_inside = is_inside || (blocked && blocked->from < to && from < blocked->to);
    }
    EXPECT_FALSE(is_beyond && is_inside) << i;
    beyond += is_beyond;
    outside += !is_inside;
  }
  EXPECT_GT(100 * beyond, 60 * outside) << beyond << " of " << outside;
}

TEST(NearNumber, of_different_numbers_knows_the_order_or_leaves_it_open) {
  Random random(2);
  int open = 0;
  for (int i = 0; i < 3000; ++i) {
    const Integer a = number(random);
    const Integer b = i % 2 == 0 ? number(random) : Integer(a + uniform(random, -1, 1));
    const int certain = certain_order(near_number(a), near_number(b));
    EXPECT_TRUE(certain == 0 || certain == sign_of(Integer(a - b))) << a << ' ' << b;
    open += certain == 0;
  }
  EXPECT_LT(open, 1600);
}

}  // namespace
}  // namespace oplus::slide
