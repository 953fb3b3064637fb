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

/// Whether a place on the segment, its ends too, is inside the parallelogram.
bool meets(const Edge& segment, const Edge& e, const Edge& f) {
  const auto blocked = blocked_interval(segment, e, f, Shift::none);
  const Fraction<AnyNumbers> from{0, 1}, to{1, 1};
  return blocked && blocked->from < to && from < blocked->to;
}

TEST(LeadingEdge, is_beyond_a_side_only_where_no_place_is_inside) {
  Random random(1);
  std::size_t beyond = 0, outside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Edge e{vector(random), vector(random)}, f{vector(random), vector(random)};
    // Anywhere, or with one end about as near to a side as numbers can be.
    Edge segment{vector(random), vector(random)};
    if (i % 2 == 0) {
      const int along = uniform(random, 0, 3);
      segment.source = e.source + f.source + (i % 4 == 0 ? e : f).direction;
      if (along > 1) segment.source = segment.source + (i % 4 == 0 ? f : e).direction;
      if (along % 2 == 1) segment.source = segment.source + Vector{uniform(random, -1, 1), 1};
    }
    const bool is_beyond =
        certainly_beyond_a_side(LeadingEdge::of(segment), LeadingEdge::of(e), LeadingEdge::of(f));
    const bool is_inside = meets(segment, e, f);
    EXPECT_FALSE(is_beyond && is_inside) << i;
    beyond += is_beyond;
    outside += !is_inside;
  }
  EXPECT_GT(10 * beyond, 5 * outside) << beyond << " of " << outside;
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
