// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/failure_kind.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace oplus {
namespace {

Chain square(int low, int high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }
Chain hole(int low, int high) { return {{low, low}, {low, high}, {high, high}, {high, low}}; }

const PlanarSet frame{{square(0, 9)}, {hole(3, 6)}, {}, {}};

std::string kind(const PlanarSet& right, const PlanarSet& given) {
  const auto found = failure(right, given);
  return found ? found->kind : "";
}

TEST(FailureKind, is_empty_for_the_right_sum) { EXPECT_EQ(kind(frame, frame), ""); }

TEST(FailureKind, holes) {
  EXPECT_EQ(kind(frame, {{square(0, 9)}, {}, {}, {}}), "hole lost");
  EXPECT_EQ(kind({{square(0, 9)}, {}, {}, {}}, frame), "hole invented");
  // As many as there were, but elsewhere.
  EXPECT_EQ(kind(frame, {{square(0, 9)}, {hole(1, 2)}, {}, {}}), "hole lost");
  const PlanarSet two{
      {square(0, 9)}, {{{1, 1}, {1, 2}, {8, 2}, {8, 1}}, {{1, 3}, {1, 4}, {8, 4}, {8, 3}}}, {}, {}};
  const PlanarSet one{{square(0, 9)}, {{{1, 1}, {1, 4}, {8, 4}, {8, 1}}}, {}, {}};
  EXPECT_EQ(kind(two, one), "holes joined");
  EXPECT_EQ(kind(one, two), "hole split");
}

TEST(FailureKind, components) {
  const PlanarSet two{{square(0, 2), square(4, 6)}, {}, {}, {}};
  EXPECT_EQ(kind(two, {{square(0, 2)}, {}, {}, {}}), "component lost");
  EXPECT_EQ(kind({{square(0, 2)}, {}, {}, {}}, two), "component invented");
  EXPECT_EQ(kind(two, {{square(0, 6)}, {}, {}, {}}), "components joined");
  EXPECT_EQ(kind({{square(0, 6)}, {}, {}, {}}, two), "component split");
  EXPECT_EQ(kind(two, {}), "component lost");
}

TEST(FailureKind, area) {
  const PlanarSet right{{square(0, 4)}, {}, {}, {}};
  EXPECT_EQ(kind(right, {{square(0, 3)}, {}, {}, {}}), "area smaller");
  EXPECT_EQ(kind(right, {{square(0, 5)}, {}, {}, {}}), "area larger");
  EXPECT_EQ(kind(right, {{{{0, 0}, {8, 0}, {8, 2}, {0, 2}}}, {}, {}, {}}),
            "other shape of equal area");
}

TEST(FailureKind,
     rounded_is_by_less_than_a_step_of_the_grid_or_a_millionth_of_the_largest_coordinate) {
  const PlanarSet right{{{{0, 0}, {9, 0}, {Rational(20, 3), Rational(20, 3)}, {0, 9}}}, {}, {}, {}};
  const auto with_vertex = [&](std::size_t i, const Point& p) {
    PlanarSet given = right;
    given.outer[0][2] = {7, 7};
    given.outer[0][i] = p;
    return given;
  };
  EXPECT_EQ(kind(right, with_vertex(2, {7, 7})), "rounded");
  EXPECT_EQ(kind(right, with_vertex(2, {6, 7})), "rounded");
  const auto found = failure(right, with_vertex(2, {7, 7}));
  EXPECT_GT(*found->squared_distance, 0);
  EXPECT_LE(*found->squared_distance, Rational(2, 9));
  EXPECT_EQ(kind(right, with_vertex(2, {8, 7})), "area larger");
  EXPECT_EQ(kind(right, with_vertex(1, {8, 0})), "area smaller");
  // On any grid.
  const Rational millionth(9, 1000000);
  PlanarSet nearly = right;
  nearly.outer[0][1].x += millionth;
  EXPECT_EQ(kind(right, nearly), "rounded");
  nearly.outer[0][1].x += millionth;
  EXPECT_EQ(kind(right, nearly), "area larger");
}

TEST(FailureKind, rounded_needs_the_same_vertices) {
  const Chain notched{{0, 0}, {2, Rational(1, 2)}, {4, 0}, {4, 4}, {0, 4}};
  const PlanarSet right{{notched}, {}, {}, {}}, hull{{square(0, 4)}, {}, {}, {}};
  EXPECT_EQ(kind(right, hull), "area larger");
  EXPECT_EQ(kind(hull, right), "area smaller");
  PlanarSet thirds = right, rounded = right;
  thirds.outer[0][1] = {2, Rational(1, 3)};
  EXPECT_EQ(kind(thirds, rounded), "rounded");
  // It starts at another vertex, and has one inside a straight line.
  Chain& chain = rounded.outer[0];
  std::rotate(chain.begin(), chain.begin() + 2, chain.end());
  chain.insert(chain.begin() + 1, Point{4, 2});
  EXPECT_EQ(kind(thirds, rounded), "rounded");
}

TEST(FailureKind, rounded_may_add_and_lose_vertices_that_are_nearly_inside_an_edge) {
  const PlanarSet right{{square(0, 4)}, {}, {}, {}};
  const auto bent = [&](const Rational& by) {
    PlanarSet given = right;
    given.outer[0].insert(given.outer[0].begin() + 1, Point{2, by});
    return given;
  };
  // A millionth of 4.
  const Rational most(4, 1000000);
  EXPECT_EQ(kind(right, bent(most)), "rounded");
  EXPECT_EQ(kind(bent(-most), right), "rounded");
  EXPECT_EQ(kind(right, bent(most * 2)), "area smaller");
  EXPECT_EQ(kind(bent(most * 2), right), "area larger");
}

TEST(FailureKind, rounded_holes_are_in_the_same_component) {
  const auto sum = [](const Rational& left) {
    return PlanarSet{{square(0, 9), square(10, 19)},
                     {hole(3, 6), {{left, 13}, {left, 16}, {16, 16}, {16, 13}}},
                     {},
                     {}};
  };
  EXPECT_EQ(kind(sum(Rational(40, 3)), sum(13)), "rounded");
  EXPECT_EQ(kind(sum(Rational(40, 3)), sum(12)), "area smaller");
  PlanarSet one_hole = sum(13);
  one_hole.holes.pop_back();
  EXPECT_EQ(kind(sum(Rational(40, 3)), one_hole), "hole lost");
}

TEST(FailureKind, low_dimensional_features) {
  PlanarSet right = frame;
  right.dangling_edges = {{{3, 4}, {6, 4}}};
  right.isolated_vertices = {{4, 5}};
  PlanarSet given = right;
  given.dangling_edges.clear();
  EXPECT_EQ(kind(right, given), "dangling edge lost");
  EXPECT_EQ(kind(given, right), "dangling edge invented");
  given = right;
  given.isolated_vertices.clear();
  EXPECT_EQ(kind(right, given), "isolated vertex lost");
  EXPECT_EQ(kind(given, right), "isolated vertex invented");
}

TEST(FailureKind, chains_that_are_not_a_boundary) {
  EXPECT_EQ(kind(frame, {{{{0, 0}, {1, 0}}}, {}, {}, {}}), "not simple");
  EXPECT_EQ(kind(frame, {{{}}, {}, {}, {}}), "not simple");
  EXPECT_EQ(kind(frame, {{{{0, 0}, {1, 0}, {2, 0}}}, {}, {}, {}}), "not simple");
  EXPECT_EQ(kind(frame, {{{{0, 0}, {4, 4}, {4, 0}, {0, 3}}}, {}, {}, {}}), "not simple");
  EXPECT_EQ(kind(frame, {{square(0, 9)}, {hole(20, 22)}, {}, {}}), "not simple");
  EXPECT_EQ(kind(frame, {{}, {hole(3, 6)}, {}, {}}), "not simple");
  EXPECT_EQ(kind(frame, {{hole(0, 9)}, {hole(3, 6)}, {}, {}}), "orientation");
  EXPECT_EQ(kind(frame, {{square(0, 9)}, {square(3, 6)}, {}, {}}), "orientation");
}

TEST(FailureKind, the_same_points_in_another_form) {
  PlanarSet given = frame;
  given.outer[0].insert(given.outer[0].begin() + 1, Point{5, 0});
  EXPECT_EQ(kind(frame, given), "not canonical");
}

}  // namespace
}  // namespace oplus
