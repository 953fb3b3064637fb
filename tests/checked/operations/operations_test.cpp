// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/operations.hpp"

#include <gtest/gtest.h>

#include "checked/operations/complement.hpp"
#include "checked/slide/slide.hpp"
#include "reference/chains/region_of.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

MinkowskiSum slid(const Region& p, const Region& q, Boundary boundary) {
  return slide_sum(p, q, boundary).sum;
}

MinkowskiSum set(const std::vector<Chain>& outer, const std::vector<Segment>& edges = {},
                 const std::vector<Point>& points = {}) {
  return {outer, {}, edges, points};
}

/// Two rooms, a corridor as wide as the square of side 1, a spike; and a cell as large as that square.
const Region rooms = together({polygon({{0, 0},
                                        {5, 0},
                                        {5, 2},
                                        {8, 2},
                                        {8, 0},
                                        {12, 0},
                                        {12, 5},
                                        {8, 5},
                                        {8, 3},
                                        {5, 3},
                                        {5, 5},
                                        {3, 5},
                                        {Rational(5, 2), 8},
                                        {2, 5},
                                        {0, 5}}),
                               polygon(box(13, 3, 14, 4))});
const Region square = polygon(box(0, 0, 1, 1));

TEST(InnerFit, of_a_part_as_large_as_the_bin_is_one_place) {
  const Region bin = polygon(box(0, 0, 100, 100));
  EXPECT_EQ(inner_fit(bin, bin, slid), set({}, {}, {{0, 0}}));
  EXPECT_EQ(inner_fit(bin, polygon(box(0, 0, 100, 101)), slid), set({}));
  EXPECT_EQ(inner_fit(bin, polygon(box(0, 0, 100, 30)), slid), set({}, {{{0, 0}, {0, 70}}}));
}

TEST(InnerFit, has_areas_edges_and_points) {
  EXPECT_EQ(inner_fit(rooms, square, slid),
            set({box(0, 0, 4, 4), box(8, 0, 11, 4)}, {{{4, 2}, {8, 2}}}, {{13, 3}}));
}

TEST(InnerFit, of_a_key_is_its_keyhole) {
  const Chain key = {{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 4}, {1, 4}, {1, 1}, {0, 1}};
  const Region hole = complement(holed(box(-5, -5, 20, 20), {translated(key, {7, 8})}));
  EXPECT_EQ(inner_fit(hole, polygon(key), slid).isolated_vertices, (std::vector<Point>{{7, 8}}));
}

TEST(InnerFit, in_an_unbounded_region_is_unbounded) {
  const MinkowskiSum places = inner_fit(complement(square), square, slid);
  EXPECT_TRUE(places.is_unbounded);
  EXPECT_EQ(places, complement(no_fit(square, square, slid)));
}

TEST(NoFit, is_open_where_the_two_touch) {
  EXPECT_EQ(no_fit(square, square, slid), set({box(-1, -1, 1, 1)}));
  const Region slot = polygon({{0, 0}, {5, 0}, {5, 3}, {3, 3}, {3, 1}, {2, 1}, {2, 3}, {0, 3}});
  const MinkowskiSum touching = no_fit(slot, square, slid);
  EXPECT_EQ(touching.dangling_edges, (std::vector<Segment>{{{2, 1}, {2, 3}}}));
}

TEST(Erosion, is_a_region) {
  EXPECT_EQ(eroded(rooms, square, slid), set({box(0, 0, 4, 4), box(8, 0, 11, 4)}));
}

TEST(Opening, keeps_exact_fits_and_loses_spikes) {
  const Region expected = together({polygon({{0, 0},
                                             {5, 0},
                                             {5, 2},
                                             {8, 2},
                                             {8, 0},
                                             {12, 0},
                                             {12, 5},
                                             {8, 5},
                                             {8, 3},
                                             {5, 3},
                                             {5, 5},
                                             {0, 5}}),
                                    polygon(box(13, 3, 14, 4))});
  EXPECT_EQ(opened(rooms, square, slid), canonical_sum(expected));
}

TEST(Closing, fills_what_the_square_does_not_fit_in) {
  const Region slit = polygon(
      {{0, 0}, {9, 0}, {9, 4}, {5, 4}, {5, 1}, {Rational(9, 2), 1}, {Rational(9, 2), 4}, {0, 4}});
  EXPECT_EQ(closed(slit, square, slid), set({box(0, 0, 9, 4)}));
  const Region ring = holed(box(0, 0, 9, 9), {box(1, 1, 5, 5), box(7, 7, Rational(15, 2), 8)});
  const Region expected = holed(box(0, 0, 9, 9), {box(1, 1, 5, 5)});
  EXPECT_EQ(closed(ring, square, slid), canonical_sum(expected));
}

TEST(Operations, with_nothing) {
  const Region nothing, plane = {{Component{}}};
  EXPECT_EQ(inner_fit(nothing, square, slid), set({}));
  EXPECT_EQ(inner_fit(square, nothing, slid), canonical_sum(plane));
  EXPECT_EQ(no_fit(square, nothing, slid), set({}));
  EXPECT_EQ(closed(nothing, square, slid), set({}));
  EXPECT_EQ(inner_fit(square, complement(square), slid), set({}));
}

TEST(Operations, are_listed_by_their_names) {
  std::vector<std::string> names;
  for (const Operation& operation : operations()) names.push_back(operation.name);
  EXPECT_EQ(names, (std::vector<std::string>{"nfp", "ifp", "erode", "open", "close"}));
}

}  // namespace
}  // namespace oplus
