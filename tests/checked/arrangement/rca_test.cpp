// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/rca.hpp"

#include <gtest/gtest.h>

#include "properties/compare/corpus.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/convolution.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"
#include "tests/reference/io/published_data.hpp"

namespace oplus {
namespace {

TEST(Rca, statistics_are_those_of_an_arrangement) {
  for (const CorpusPair& row : corpus()) {
    const Statistics closed = rca(row.p, row.q, Boundary::closed).statistics;
    EXPECT_EQ(closed.count("segments in the arrangement"), reduced_convolution(row.p, row.q).size())
        << row.name;
    // Euler: V + F = E + 1 + connected components.
    EXPECT_GE(closed.count("arrangement vertices") + closed.count("arrangement faces"),
              closed.count("arrangement edges") +
                  (closed.count("segments in the arrangement") == 0 ? 1 : 2))
        << row.name;
    EXPECT_LT(closed.count("hole tests"), closed.count("arrangement faces")) << row.name;
    const Statistics open = rca(row.p, row.q, Boundary::open).statistics;
    EXPECT_EQ(open.count("arrangement edges"), closed.count("arrangement edges")) << row.name;
    EXPECT_GE(open.count("hole tests"), closed.count("hole tests")) << row.name;
  }
}

TEST(Rca, of_published_pairs_has_the_holes_and_isolated_vertices_that_they_are_known_for) {
  const auto sum = [](const std::string& p, const std::string& q, Boundary boundary) {
    return rca(published(p), published(q), boundary).sum;
  };
  using Points = std::vector<Point>;
  const std::string p = "isolated_vertex_part1", q = "isolated_vertex_part2";
  EXPECT_EQ(sum(p, q, Boundary::open).isolated_vertices, (Points{{3, 3}}));
  EXPECT_EQ(sum(p, q, Boundary::closed).isolated_vertices, Points{});
  EXPECT_EQ(sum("pwh5", "pwh5", Boundary::open).isolated_vertices,
            (Points{{4, 4}, {4, 12}, {12, 4}, {12, 12}}));
  EXPECT_EQ(sum("fork_part1", "fork_part2", Boundary::closed).holes.size(), 600u);
}

TEST(Rca, is_exact_where_no_double_is) {
  const Rational tiny = 1 / Rational("1" + std::string(400, '0'));
  // The slot is wider than the square by less than any double: a hole instead of a dangling edge.
  const auto slotted = [](const Rational& top) {
    return Region{{{box(0, 0, 5, 5), {backwards(box(1, 1, 4, top))}}}};
  };
  const Region square = polygon(box(0, 0, 2, 2));
  EXPECT_EQ(rca(slotted(3 + tiny), square, Boundary::closed).sum.holes,
            (std::vector<Chain>{{{3, 3}, {3, 3 + tiny}, {4, 3 + tiny}, {4, 3}}}));
  EXPECT_EQ(rca(slotted(3), square, Boundary::open).sum.dangling_edges,
            (std::vector<Segment>{{{3, 3}, {4, 3}}}));
  const PlanarSet closed = rca(slotted(3 - tiny), square, Boundary::open).sum;
  EXPECT_EQ(closed, canonical_sum(polygon(box(0, 0, 7, 7))));
}

}  // namespace
}  // namespace oplus
