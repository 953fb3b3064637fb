// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/touching_exteriors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// The number of exteriors at each point; the points in lexicographic order.
std::vector<int> exteriors(const Region& region) {
  std::vector<int> result;
  for (const TouchingExteriors& t : touching_exteriors(region)) result.push_back(t.exteriors);
  return result;
}

TEST(TouchingExteriors, AreEmptyWhereChainsDoNotTouch) {
  EXPECT_TRUE(exteriors({{{box(0, 0, 3, 3), {backwards(box(1, 1, 2, 2))}}}}).empty());
}

TEST(TouchingExteriors, CountOneAroundComponentsThatTouch) {
  const Region two{{{box(0, 0, 1, 1), {}}, {box(1, 1, 2, 2), {}}}};
  EXPECT_EQ(exteriors(two), std::vector<int>{1});
  EXPECT_EQ(touching_exteriors(two)[0].at, (Point{1, 1}));
  const Region three{{{{{0, 0}, {2, -1}, {2, 1}}, {}},
                      {{{0, 0}, {-1, 2}, {-2, 1}}, {}},
                      {{{0, 0}, {-2, -1}, {-1, -2}}, {}}}};
  EXPECT_EQ(exteriors(three), std::vector<int>{1});
}

TEST(TouchingExteriors, CountTwoWhereAHoleTouchesAnEdgeOrAVertex) {
  const Chain hole = backwards({{2, 0}, {3, 1}, {2, 2}, {1, 1}});
  EXPECT_EQ(exteriors({{{box(0, 0, 4, 4), {hole}}}}), std::vector<int>{2});
  EXPECT_EQ(exteriors({{{{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, {hole}}}}), std::vector<int>{2});
}

TEST(TouchingExteriors, CountTheHolesThatMeet) {
  const Chain right = backwards({{2, 2}, {3, 1}, {3, 3}}),
              left = backwards({{2, 2}, {1, 3}, {1, 1}});
  const Chain above = backwards({{2, 2}, {Rational(5, 2), 3}, {Rational(3, 2), 3}});
  EXPECT_EQ(exteriors({{{box(0, 0, 4, 4), {left, right}}}}), std::vector<int>{2});
  EXPECT_EQ(exteriors({{{box(0, 0, 4, 4), {left, above, right}}}}), std::vector<int>{3});
}

TEST(TouchingExteriors, CountOneWhereAnIslandTouchesItsHole) {
  const Region island{
      {{box(0, 0, 4, 4), {backwards(box(1, 1, 3, 3))}}, {{{1, 2}, {2, 1}, {2, 2}}, {}}}};
  EXPECT_EQ(exteriors(island), (std::vector<int>{1, 1}));
}

TEST(TouchingExteriors, CountTwoWhereAComponentTouchesAHoleThatTouches) {
  // A hole from the lower edge's middle, and from below a component up to it.
  const Region both{
      {{box(0, 0, 4, 4), {backwards({{2, 0}, {3, 1}, {1, 1}})}}, {{{2, 0}, {1, -1}, {3, -1}}, {}}}};
  EXPECT_EQ(exteriors(both), std::vector<int>{2});
}

}  // namespace
}  // namespace oplus
