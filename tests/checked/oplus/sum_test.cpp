// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <type_traits>

#include "checked/joined_thread.hpp"
#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion frame =
    polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
const ValidRegion square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
/// As large as the frame's hole.
const ValidRegion plug = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
/// As wide as the frame's hole, not as high.
const ValidRegion bar = polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}});

TEST(ValidSet, is_empty_by_default) {
  const ValidSet sum;
  EXPECT_EQ(sum.boundary(), Boundary::closed);
  EXPECT_TRUE(sum.components().empty());
  EXPECT_EQ(sum.region(), ValidRegion());
  EXPECT_EQ(area(sum), 0);
  EXPECT_EQ(sum, minkowski_sum(frame, ValidRegion()));
  EXPECT_EQ(sum, minkowski_sum(ValidRegion(), ValidRegion()));
}

TEST(ValidSet, has_components_with_their_holes) {
  const ValidSet sum = minkowski_sum(frame, square);
  const Component expected = {{{0, 0}, {5, 0}, {5, 5}, {0, 5}}, {{{2, 2}, {2, 3}, {3, 3}, {3, 2}}}};
  EXPECT_EQ(sum.components(), std::vector{expected});
  EXPECT_EQ(sum.region().components(), std::vector{expected});
  EXPECT_EQ(sum.value(), (PlanarSet{{expected.outer}, expected.holes, {}, {}}));
  EXPECT_EQ(area(sum), 24);
  EXPECT_TRUE(sum.dangling_edges().empty() && sum.isolated_vertices().empty());
  // It is a region again.
  EXPECT_EQ(area(minkowski_sum(sum.region(), square)), 36);
}

/// With the address sanitizer, references into what is gone would end the test.
TEST(ValidSet, without_a_name_can_be_looped_over) {
  std::size_t vertices = 0;
  for (const Component& component : minkowski_sum(frame, square).components())
    vertices += component.outer.size() + component.holes.at(0).size();
  for (const Component& component : minkowski_sum(frame, square).region().components())
    vertices += component.outer.size();
  for (const Chain& chain : minkowski_sum(frame, square).value().holes) vertices += chain.size();
  for (const Component& component : polygon({{0, 0}, {1, 0}, {0, 1}}).components())
    vertices += component.outer.size();
  EXPECT_EQ(vertices, 19U);
  for (const Segment& edge :
       minkowski_sum(frame, -bar, {.boundary = Boundary::open}).dangling_edges())
    EXPECT_NE(edge.source, edge.target);
  static_assert(!std::is_reference_v<decltype(minkowski_sum(frame, square).components())>);
  static_assert(!std::is_reference_v<decltype(minkowski_sum(frame, square).isolated_vertices())>);
}

TEST(ValidSet, splits_chains_into_components_at_touching_points) {
  const ValidRegion touching = read_wkt("MULTIPOLYGON(((0 0,2 0,0 2,0 0)),((2 0,4 0,4 2,2 0)))");
  const ValidSet sum =
      minkowski_sum(touching, polygon({{0, 0}, {1, 0}, {0, 1}}), {.boundary = Boundary::open});
  EXPECT_EQ(ValidRegion(sum.region().region()), sum.region());
}

TEST(ValidSet, has_dangling_edges_and_isolated_vertices_if_open) {
  const ValidSet closed = minkowski_sum(frame, -plug);
  const ValidSet open = minkowski_sum(frame, -plug, {.boundary = Boundary::open});
  EXPECT_EQ(open.boundary(), Boundary::open);
  EXPECT_EQ(open.isolated_vertices(), std::vector{(Point{1, 1})});
  EXPECT_TRUE(open.dangling_edges().empty());
  EXPECT_TRUE(closed.isolated_vertices().empty());
  EXPECT_EQ(open.components(), closed.components());
  EXPECT_NE(open, closed);

  const ValidSet passage = minkowski_sum(frame, -bar, {.boundary = Boundary::open});
  EXPECT_EQ(passage.dangling_edges(), std::vector{(Segment{{1, 1}, {1, 2}})});
  EXPECT_TRUE(passage.isolated_vertices().empty());
}

TEST(ValidSet, answers_where_points_are) {
  const ValidSet closed = minkowski_sum(frame, -bar);
  const ValidSet open = minkowski_sum(frame, -bar, {.boundary = Boundary::open});
  EXPECT_EQ(locate({1, 1.5}, open), Location::boundary);
  EXPECT_EQ(locate({1, 1.5}, closed), Location::inside);
  EXPECT_EQ(locate({"4", 2}, closed), Location::boundary);
  EXPECT_EQ(locate({"13/3", 2}, closed), Location::outside);
  EXPECT_TRUE(contains(closed, {4, 2}));
  EXPECT_FALSE(contains(open, {4, 2}));
  EXPECT_FALSE(contains(open, {1, 1.5}));
  EXPECT_TRUE(contains(open, {2, 1.5}));
  EXPECT_FALSE(contains(closed, {5, 2}));
}

TEST(ValidSet, says_where_its_edges_came_from_if_asked) {
  EXPECT_TRUE(minkowski_sum(frame, square).origins().empty());
  const ValidSet sum = minkowski_sum(frame, square, {.with_origins = true});
  ASSERT_EQ(sum.origins().size(), 8U);
  // The lower edge is that of the frame and that of the square, each at a vertex of the other.
  const std::vector<Origin> expected = {{Summand::P, {0, 0}, {0, 0}}, {Summand::Q, {0, 0}, {0, 1}}};
  EXPECT_EQ(sum.origins()[0], expected);
  // The hole's first edge is that of the frame's hole, chain 1.
  EXPECT_EQ(sum.origins()[4][0].edge.chain, 1U);
}

TEST(ValidSet, has_statistics) {
  const ValidSet sum = minkowski_sum(frame, square);
  EXPECT_NE(sum.statistics().begin(), sum.statistics().end());
  const Statistics of_temporary = minkowski_sum(frame, square).statistics();
  EXPECT_EQ(of_temporary.begin()->name, sum.statistics().begin()->name);
}

TEST(ValidSet, is_the_same_by_each_number_of_threads) {
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const ValidSet expected = minkowski_sum(frame, -bar, {.boundary = boundary});
    for (const unsigned threads : {0U, 2U, 5U})
      EXPECT_EQ(minkowski_sum(frame, -bar, {.boundary = boundary, .threads = threads}), expected);
  }
}

TEST(ValidSet, may_be_asked_by_many_threads) {
  for (int round = 0; round < 20; ++round) {
    const ValidSet sum = minkowski_sum(frame, square);
    std::vector<const Component*> seen(8);
    std::vector<std::size_t> holes(8);
    {
      std::vector<JoinedThread> threads;
      for (std::size_t i = 0; i < seen.size(); ++i)
        threads.emplace_back([&, i, copy = sum] {
          seen[i] = copy.components().data();
          holes[i] = copy.components()[0].holes.size();
        });
    }
    EXPECT_EQ(seen, std::vector(8, sum.components().data()));
    EXPECT_EQ(holes, std::vector<std::size_t>(8, 1));
  }
}

TEST(ValidSet, keeps_its_value_while_copies_change) {
  ValidSet sum = minkowski_sum(frame, square);
  const ValidSet copy = sum;
  sum = minkowski_sum(square, square);
  EXPECT_EQ(area(copy), 24);
  EXPECT_EQ(area(sum), 4);
}

TEST(Verify, tells_right_sums_from_wrong_ones) {
  const ValidSet sum = minkowski_sum(frame, square);
  const ValidSet open = minkowski_sum(frame, -plug, {.boundary = Boundary::open});
  EXPECT_TRUE(verify(frame, square, sum).is_sum());
  EXPECT_TRUE(verify(frame, -plug, open).is_sum());

  const ClaimedSum filled = {polygon({{0, 0}, {5, 0}, {5, 5}, {0, 5}}).region(), {}, {}};
  const Verdict verdict = verify(frame, square, filled);
  ASSERT_EQ(verdict.reasons.size(), 1U);
  EXPECT_EQ(verdict.reasons[0].kind, ReasonKind::missing_hole);
  EXPECT_EQ(describe(verdict.reasons[0].kind), "missing hole");
  EXPECT_EQ(verdict.right, sum.value());
  EXPECT_FALSE(contains(sum, verdict.reasons[0].witness));
}

TEST(Verify, makes_coordinates_canonical_and_refuses_zero_denominators) {
  ClaimedSum given = {polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}).region(), {}, {}};
  given.region.components[0].outer[2].x.get_num() = 4;
  given.region.components[0].outer[2].x.get_den() = 2;
  EXPECT_TRUE(verify(square, square, given).is_sum());
  given.region.components[0].outer[2].x.get_den() = 0;
  EXPECT_THROW(verify(square, square, given), InvalidInput);
  given.region = square.region();
  Point bad;
  bad.y.get_den() = 0;
  given.isolated_vertices = {bad};
  EXPECT_THROW(verify(square, square, given, Boundary::open), InvalidInput);
  given.isolated_vertices.clear();
  given.dangling_edges = {{{0, 0}, bad}};
  EXPECT_THROW(verify(square, square, given, Boundary::open), InvalidInput);
}

}  // namespace
}  // namespace oplus
