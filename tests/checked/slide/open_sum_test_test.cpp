// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/open_sum_test.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "reference/definitions/collision.hpp"
#include "reference/families/family.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus::slide {
namespace {

Region region(const char* text) { return region_from(text).region; }

template <typename Numbers>
class OpenSumTestIn : public testing::Test {};
TYPED_TEST_SUITE(OpenSumTestIn, AllNumbers);

/// Asks about places on lines in a pair; coordinates are integers, and need not be scaled.
template <typename Numbers>
class Asked {
 public:
  Asked(const Region& p, const Region& q)
      : scaling_(scaling_of(p, q)),
        summands_(p, q, scaling_, 0),
        rays_(rays_of(summands_)),
        test_(summands_, rays_) {}

  bool contains(const Segment& segment, const mpz_class& n, const mpz_class& d) {
    const IntegerSegment<Numbers> exact = integer_segment<Numbers>(segment);
    return test_.contains(track_on(exact, scaling_), fraction<Numbers>(n, d));
  }

 private:
  Scaling scaling_;
  IntegerSummands<Numbers> summands_;
  RaysOfBoth<Numbers> rays_;
  OpenSumTest<Numbers> test_;
};

bool contains_by_definition(const Region& p, const Region& q, const Point& x) {
  return interiors_meet(p, translated(reflected(q), x));
}

/// The place n / 4 of segments around all sums of vertices and at the middles of sides.
template <typename Numbers>
void expect_as_defined(const Region& p, const Region& q, Random& random, std::size_t& outside) {
  Asked<Numbers> asked(p, q);
  for (const Segment& e : edges(p)) {
    const std::vector<Segment> of_q = edges(q);
    const Segment& f =
        of_q[static_cast<std::size_t>(uniform(random, 0, static_cast<int>(of_q.size()) - 1))];
    for (const Segment& slid : {Segment{e.source + f.source, e.target + f.source},
                                Segment{e.source + f.source, e.source + f.target}}) {
      for (const int n : {0, 1, 2, 4}) {
        const Point x = slid.source + Rational(Rational(n) / 4) * direction_of(slid);
        const bool expected = contains_by_definition(p, q, x);
        outside += expected ? 0 : 1;
        ASSERT_EQ(asked.contains(slid, n, 4), expected)
            << testing::PrintToString(p) << testing::PrintToString(q) << testing::PrintToString(x);
      }
    }
  }
}

TYPED_TEST(OpenSumTestIn, answers_as_the_definition) {
  Random random(11);
  std::size_t outside = 0;
  for (const char* name : {"tight", "grid", "holes", "components", "islands"}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Summands pair = generate(*find_family(name), 5, seed);
      if (!scaling_of(pair.p, pair.q).is_trivial()) continue;
      expect_as_defined<TypeParam>(pair.p, pair.q, random, outside);
    }
  }
  EXPECT_GT(outside, 150u);
}

/// The square from (0, 0) to (2, 2) with a hole that touches all its sides from within.
const Region square_with_diamond = region("POLYGON((0 0,2 0,2 2,0 2,0 0),(0 1,1 2,2 1,1 0,0 1))");

TYPED_TEST(OpenSumTestIn, does_not_take_edges_for_crossing_where_holes_touch_both) {
  // docs/findings.md, on Observation 2.2.4.
  Asked<TypeParam> asked(square_with_diamond, square_with_diamond);
  EXPECT_FALSE(asked.contains({{3, 3}, {4, 3}}, 0, 1));
  EXPECT_TRUE(asked.contains({{3, 3}, {5, 3}}, 1, 8)) << "beside it";
  EXPECT_TRUE(asked.contains({{2, 2}, {3, 2}}, 0, 1));
}

TYPED_TEST(OpenSumTestIn, sees_a_sector_of_the_summand_and_not_of_one_of_its_chains) {
  // A triangle in the hole, with a vertex where the hole touches a side; and one beyond the side.
  const Region small = polygon({{0, 0}, {-4, 2}, {-4, -2}});
  const Region large = region("POLYGON((0 0,20 0,20 20,0 20,0 0),(0 10,10 20,20 10,10 0,0 10))");
  Asked<TypeParam> asked(large, small);
  EXPECT_FALSE(asked.contains({{0, 10}, {1, 10}}, 0, 1));
  EXPECT_TRUE(asked.contains({{-1, 10}, {0, 10}}, 0, 1));
  for (const Point& x : {Point{0, 10}, Point{0, 11}, Point{4, 10}, Point{20, 10}, Point{24, 10}})
    EXPECT_EQ(asked.contains({x, x + Vector{1, 0}}, 0, 1), contains_by_definition(large, small, x));
}

TYPED_TEST(OpenSumTestIn, sees_components_inside_components) {
  const Region frame = region(
      "MULTIPOLYGON(((0 0,20 0,20 20,0 20,0 0),(2 2,2 18,18 18,18 2,2 2)),((5 5,9 5,9 9,5 9,5 5)))");
  const Region dots = region("MULTIPOLYGON(((0 0,1 0,1 1,0 1,0 0)),((40 0,41 0,41 1,40 1,40 0)))");
  Asked<TypeParam> asked(frame, dots);
  EXPECT_TRUE(asked.contains({{8, 8}, {9, 8}}, 0, 1)) << "the first dot in the small square";
  EXPECT_FALSE(asked.contains({{13, 13}, {14, 13}}, 0, 1)) << "in the hole";
  EXPECT_TRUE(asked.contains({{48, 8}, {49, 8}}, 0, 1)) << "the second dot in the small square";
  EXPECT_FALSE(asked.contains({{100, 8}, {101, 8}}, 0, 1));
}

}  // namespace
}  // namespace oplus::slide
