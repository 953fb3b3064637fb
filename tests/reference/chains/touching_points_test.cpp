// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/touching_points.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reference/chains/validity.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "tests/reference/chains/random_regions.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(TouchingPoints, are_those_of_different_chains) {
  // A hole touching an edge and a vertex of its outer chain; an island whose edge has the corner.
  const Region region{{{box(0, 0, 4, 4), {backwards({{2, 0}, {4, 4}, {1, 1}})}},
                       {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}}}};
  EXPECT_EQ(touching_points(region), (std::vector<Point>{{2, 0}, {4, 4}}));
  EXPECT_TRUE(touching_points(holed(box(0, 0, 5, 5), {box(1, 1, 2, 2), box(3, 1, 4, 3)})).empty());
}

TEST(TouchingPoints, are_found_whichever_chain_has_the_vertex) {
  const Component triangle{{{1, 2}, {2, 1}, {3, 2}}, {}};
  const Component flat{{{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {}};
  EXPECT_EQ(touching_points({{triangle, flat}}), (std::vector<Point>{{2, 1}}));
  EXPECT_EQ(touching_points({{flat, triangle}}), (std::vector<Point>{{2, 1}}));
}

TEST(TouchingPoints, and_pieces_of_random_regions_are_those_of_all_pairs) {
  Random random(23);
  int touched = 0, cut_in_the_middle = 0;
  for (int i = 0; i < 6000; ++i) {
    const Region region = one_in(random, 30) ? random_cells(random) : random_region(random);
    if (find_defect(region)) continue;
    const std::vector<Chain> all = chains(region);
    std::set<Point> touching;
    std::vector<std::vector<Segment>> pieces;
    for (const Chain& a : all) {
      for (const Chain& b : all)
        if (&a != &b)
          for (const Point& p : a)
            if (lies_on_one(p, edges(b))) touching.insert(p);
      pieces.emplace_back();
      for (const Segment& e : edges(a))
        for (const Segment& piece : cut_where_met(e, edges(region))) pieces.back().push_back(piece);
    }
    ASSERT_EQ(touching_points(region), std::vector<Point>(touching.begin(), touching.end()));
    ASSERT_EQ(pieces_by_chain(region), pieces);
    touched += !touching.empty();
    cut_in_the_middle += boundary_pieces(region).size() > vertex_count(region);
  }
  EXPECT_GE(touched, 100);
  EXPECT_GE(cut_in_the_middle, 20);
}

}  // namespace
}  // namespace oplus
