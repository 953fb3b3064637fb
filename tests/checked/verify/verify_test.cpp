// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/verify.hpp"

#include <gtest/gtest.h>

#include "checked/verify/sum_by_convex_parts.hpp"
#include "checked/verify/witness.hpp"
#include "properties/compare/corpus.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/families/family.hpp"
#include "reference/oracle/oracle.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Region unit = polygon(box(0, 0, 1, 1));

/// A frame of width 1 around a hole of side 2: what is summed with a unit square has a hole of side
/// 1.
const Region frame{{{box(0, 0, 4, 4), {backwards(box(1, 1, 3, 3))}}}};
const Region sum_of_frame{{{box(0, 0, 5, 5), {backwards(box(2, 2, 3, 3))}}}};

std::vector<ReasonKind> kinds(const Verdict& verdict) {
  std::vector<ReasonKind> result;
  for (const Reason& reason : verdict.reasons) result.push_back(reason.kind);
  return result;
}

using Kinds = std::vector<ReasonKind>;

TEST(Verify, accepts_the_sums_of_the_corpus) {
  for (const CorpusPair& row : corpus()) {
    for (const auto& [boundary, sum] :
         {std::pair(Boundary::closed, row.closed), {Boundary::open, row.open}}) {
      const Verdict verdict = verify(row.p, row.q, boundary, sum);
      EXPECT_TRUE(verdict.is_sum()) << row.name;
      EXPECT_EQ(verdict.right, sum) << row.name;
      EXPECT_FALSE(verdict.addends.has_value()) << row.name;
    }
  }
}

/// Not by the verifier's word alone: its sum is the oracle's.
TEST(Verify, adds_convex_parts_to_the_sum_of_the_oracle) {
  std::size_t features = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const auto [p, q] = generate(family, family.smallest + 1, seed);
      if (vertex_count(p) * vertex_count(q) > 200) continue;  // the oracle takes seconds
      const OracleSums sums = oracle_sums(p, q);
      EXPECT_EQ(sum_by_convex_parts(p, q, Boundary::closed), sums.closed) << family.name;
      EXPECT_EQ(sum_by_convex_parts(p, q, Boundary::open), sums.open) << family.name;
      features += sums.open.dangling_edges.size() + sums.open.isolated_vertices.size();
    }
  }
  EXPECT_GT(features, 0U);
}

/// Wherever it is: outside, inside, or a vertex of the sum.
TEST(Verify, refuses_a_chain_that_is_a_point) {
  for (const Point& x : {Point{9, 9}, {1, 1}, {0, 0}, {Rational(5, 2), Rational(5, 2)}}) {
    for (const std::size_t times : {1U, 2U, 3U, 4U}) {
      for (const bool hole : {true, false}) {
        for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
          Region given = sum_of_frame;
          if (hole)
            given.components[0].holes.push_back(Chain(times, x));
          else
            given.components.push_back({Chain(times, x), {}});
          const Verdict verdict = verify(frame, unit, boundary, {given, {}, {}});
          ASSERT_EQ(kinds(verdict), Kinds{ReasonKind::unsimple_boundary});
          EXPECT_EQ(verdict.reasons[0].witness, x);
          EXPECT_EQ(verdict.reasons[0].in_sum, x == (Point{1, 1}) || x == (Point{0, 0}));
          EXPECT_EQ(verdict.reasons[0].in_given, verdict.reasons[0].in_sum);
          EXPECT_EQ(verdict.addends.has_value(), verdict.reasons[0].in_sum);
        }
      }
    }
  }
}

TEST(Verify, refuses_a_point_for_an_empty_sum) {
  EXPECT_EQ(kinds(verify({}, unit, Boundary::closed, ClaimedSum{polygon({{1, 1}}), {}, {}})),
            Kinds{ReasonKind::unsimple_boundary});
}

TEST(Verify, a_sum_by_its_chains_may_have_a_hole_in_nothing) {
  PlanarSet sum = sum_by_definition(frame, unit, Boundary::closed);
  EXPECT_TRUE(verify(frame, unit, Boundary::closed, sum).is_sum());
  sum.outer.clear();
  const Verdict verdict = verify(frame, unit, Boundary::closed, sum);
  ASSERT_FALSE(verdict.is_sum());
  EXPECT_EQ(verdict.reasons.front().kind, ReasonKind::missing_component);
}

/// Which outer chain a hole goes to is then arbitrary, but nothing is accepted.
TEST(Verify, refuses_a_sum_by_its_chains_where_they_cross) {
  const PlanarSet right = sum_by_definition(frame, unit, Boundary::closed);
  for (const Chain& outer : {box(3, 3, 7, 7), box(-1, 1, 6, 4), box(4, 4, 6, 6)}) {
    for (const Chain& hole : {backwards(box(1, 1, 4, 6)), backwards(box(2, 2, 4, 4))}) {
      PlanarSet crossing = right;
      crossing.outer.push_back(outer);
      EXPECT_FALSE(verify(frame, unit, Boundary::closed, crossing).is_sum());
      crossing.holes.push_back(hole);
      EXPECT_FALSE(verify(frame, unit, Boundary::closed, crossing).is_sum());
      crossing.outer.pop_back();
      EXPECT_FALSE(verify(frame, unit, Boundary::closed, crossing).is_sum());
    }
  }
}

TEST(Verify, of_huge_and_tiny_coordinates) {
  Rational huge = 1;
  for (int i = 0; i < 300; ++i) huge *= 10;
  const Rational tiny = 1 / huge;
  const Region p = polygon(box(0, 0, huge, tiny));
  const PlanarSet sum = sum_by_definition(p, unit, Boundary::closed);
  EXPECT_EQ(sum, canonical_sum(polygon(box(0, 0, huge + 1, tiny + 1))));
  Region given = region_of(sum);
  EXPECT_TRUE(verify(p, unit, Boundary::closed, {given, {}, {}}).is_sum());
  given.components[0].outer[2].x += tiny;
  EXPECT_FALSE(verify(p, unit, Boundary::closed, {given, {}, {}}).is_sum());
}

/// The plug fits the hole, so that the open sum lacks the middle of the square; the closed sum does not.
TEST(Verify, a_witness_is_on_no_isolated_vertex) {
  const Region plug = polygon(box(0, 0, 2, 2));
  const Verdict verdict = verify(frame, plug, Boundary::closed, ClaimedSum{});
  ASSERT_EQ(kinds(verdict), Kinds{ReasonKind::missing_component});
  EXPECT_NE(verdict.reasons[0].witness, (Point{3, 3}));
  EXPECT_TRUE(verdict.addends.has_value());
}

/// Neither where an edge is missing, nor where one is too much.
TEST(Verify, witnesses_on_edges_are_on_no_isolated_vertex) {
  const Region plug = polygon(box(0, 0, 2, 2)),
               slot{{{box(0, 0, 5, 4), {backwards(box(1, 1, 4, 3))}}}};
  const Point middle{Rational(7, 2), 3};
  const auto expect = [&](const Region& p, const ClaimedSum& given, const Kinds& expected) {
    const Verdict verdict = verify(p, plug, Boundary::open, given);
    EXPECT_EQ(kinds(verdict), expected);
    for (const Reason& reason : verdict.reasons) {
      EXPECT_EQ(reason.in_sum, interiors_meet(p, translated(reflected(plug), reason.witness)));
      EXPECT_NE(reason.in_sum || reason.witness == middle, reason.in_given);
    }
  };
  expect(frame, {polygon(box(0, 0, 6, 6)), {{{2, 3}, {4, 3}}}, {}},
         {ReasonKind::additional_dangling_edge, ReasonKind::additional_dangling_edge});
  expect(slot, {polygon(box(0, 0, 7, 6)), {}, {middle}},
         {ReasonKind::missing_dangling_edge, ReasonKind::missing_dangling_edge,
          ReasonKind::additional_isolated_vertex});
}

/// Of those that are one difference: the chain runs forth and back in it, and overlaps another one.
TEST(Verify, a_witness_is_in_the_largest_of_faces) {
  const Chain spike = {{0, 0}, {8, 0}, {8, 6}, {6, 2}, {8, 6}, {8, 9}, {0, 9}};
  const Region given{{{spike, {}}, {box(1, 8, 2, 10), {}}}};
  const Verdict verdict = verify({}, unit, Boundary::closed, {given, {}, {}});
  ASSERT_FALSE(verdict.is_sum());
  EXPECT_EQ(verdict.reasons[0].size, 2 * 73);
  EXPECT_EQ(verdict.reasons[0].witness, (Point{4, 4})) << "below the middle, (4, 9/2)";
}

/// At each attempt.
TEST(Verify, the_second_verdict_may_meet_isolated_vertices) {
  const Rational tiny(1, 64);
  const Chain sum = box(0, 0, 6, 6);
  std::vector<Point> met;
  Region around{{{box(0, 0, 6 - tiny, 6 - tiny), {}}}};
  for (const int attempt : {0, 1, 2}) {
    const Point x = point_near(edges(sum), 0, true, attempt);
    met.push_back(x);
    around.components[0].holes.push_back(backwards(box(x.x - tiny, x.y - tiny, x.x, x.y)));
  }
  const Region plug = polygon(box(0, 0, tiny, tiny));
  ASSERT_EQ(sum_by_definition(around, plug, Boundary::open).isolated_vertices,
            sorted_without_copies(met));
  ASSERT_EQ(sorted_without_copies(met).size(), 3U);
  EXPECT_TRUE(verify(around, plug, Boundary::closed, {polygon(sum), {}, {}}).is_sum());
}

/// What is given is compared with the sum in one form, whatever its chains start with.
TEST(Verify,
     refuses_chains_that_touch_themselves_where_they_start_and_components_that_are_there_twice) {
  const auto of = [](const Region& given) {
    return kinds(verify(frame, unit, Boundary::closed, {given, {}, {}}));
  };
  Chain chain{{0, 0}, {4, -2}, {4, -1}, {0, 0}, {4, 1}, {4, 2}};
  const Kinds found = of(polygon(chain));
  EXPECT_FALSE(found.empty());
  std::rotate(chain.begin(), chain.begin() + 3, chain.end());
  EXPECT_EQ(of(polygon(chain)), found);

  Region twice = sum_of_frame;
  twice.components.push_back({twice.components[0].outer, {}});
  EXPECT_FALSE(of(twice).empty());
  std::swap(twice.components[0], twice.components[1]);
  EXPECT_FALSE(of(twice).empty());
}

}  // namespace
}  // namespace oplus
