// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/nesting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "checked/arrangement/hole_test.hpp"
#include "reference/families/fork.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

using Halfedge = ConvolutionArrangement::Halfedge;

/// Segments along chains, as if they were a convolution.
std::vector<ConvolutionSegment> along(const std::vector<Chain>& chains) {
  std::vector<ConvolutionSegment> segments;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    std::size_t i = 0;
    for (const Segment& e : edges(chains[c])) segments.push_back({e, {{}, {c, i++}, {}}, false});
  }
  return segments;
}

/// The verdicts of loops, by the smallest vertex of each; the hole test knows the holes' smallest
/// vertices.
std::map<Point, LoopVerdict> verdicts(const std::vector<Chain>& chains,
                                      const std::vector<Point>& boundary,
                                      std::vector<Point>* asked = nullptr) {
  const ConvolutionArrangement a(along(chains));
  const std::vector<OrientableLoop> loops = orientable_loops(a);
  const auto smallest = [&](const OrientableLoop& loop) {
    std::vector<Point> points;
    for (const Halfedge h : loop) points.push_back(a.point(a.source(h)));
    return *std::min_element(points.begin(), points.end());
  };
  const auto is_hole_right_of = [&](Halfedge h) {
    const auto loop = std::find_if(loops.begin(), loops.end(), [&](const OrientableLoop& one) {
      return std::find(one.begin(), one.end(), h) != one.end();
    });
    if (asked) asked->push_back(smallest(*loop));
    return std::find(boundary.begin(), boundary.end(), smallest(*loop)) != boundary.end();
  };
  const std::vector<LoopVerdict> judged = judge(a, loops, is_hole_right_of);
  std::map<Point, LoopVerdict> result;
  for (std::size_t i = 0; i < loops.size(); ++i) result[smallest(loops[i])] = judged[i];
  return result;
}

TEST(Nesting, an_external_loop_holds_holes_that_hold_external_loops) {
  const auto found =
      verdicts({box(0, 0, 9, 9), backwards(box(1, 1, 8, 8)), box(2, 2, 7, 7)}, {{1, 1}, {2, 2}});
  const std::map<Point, LoopVerdict> expected = {{{0, 0}, LoopVerdict::boundary},
                                                 {{1, 1}, LoopVerdict::boundary},
                                                 {{2, 2}, LoopVerdict::boundary}};
  EXPECT_TRUE(found == expected);
}

TEST(Nesting, drops_an_external_loop_in_an_external_one_unasked) {
  std::vector<Point> asked;
  const auto found = verdicts({box(0, 0, 9, 9), box(1, 1, 8, 8)}, {{1, 1}}, &asked);
  EXPECT_EQ(found.at({1, 1}), LoopVerdict::not_nested);
  EXPECT_TRUE(asked.empty());
}

TEST(Nesting, drops_a_hole_in_a_hole_unasked) {
  std::vector<Point> asked;
  const auto found = verdicts(
      {box(0, 0, 9, 9), backwards(box(1, 1, 8, 8)), backwards(box(2, 2, 7, 7))}, {{1, 1}}, &asked);
  EXPECT_EQ(found.at({1, 1}), LoopVerdict::boundary);
  EXPECT_EQ(found.at({2, 2}), LoopVerdict::not_nested);
  EXPECT_EQ(asked, (std::vector<Point>{{1, 1}}));
}

TEST(Nesting, judges_what_is_in_a_fallen_loop_as_its_sibling) {
  const std::vector<Chain> chains = {box(0, 0, 9, 9), backwards(box(1, 1, 8, 8)),
                                     backwards(box(2, 2, 7, 7)), box(3, 3, 6, 6)};
  const auto found = verdicts(chains, {{2, 2}, {3, 3}});
  EXPECT_EQ(found.at({1, 1}), LoopVerdict::not_boundary);
  EXPECT_EQ(found.at({2, 2}), LoopVerdict::boundary);
  EXPECT_EQ(found.at({3, 3}), LoopVerdict::boundary);
}

TEST(Nesting, what_is_inside_a_loop_of_the_wrong_kind_stays_in_the_sum) {
  const auto found =
      verdicts({box(0, 0, 9, 9), box(1, 1, 8, 8), backwards(box(2, 2, 7, 7))}, {{2, 2}});
  EXPECT_EQ(found.at({1, 1}), LoopVerdict::not_nested);
  EXPECT_EQ(found.at({2, 2}), LoopVerdict::boundary);
}

TEST(Nesting, asks_once_a_loop) {
  const Summands fork = fork_and_l(4);
  const ConvolutionArrangement a(reduced_convolution(fork.p, fork.q));
  const auto test = hierarchy_hole_test(fork.p, fork.q);
  std::size_t asked = 0;
  const std::vector<OrientableLoop> loops = orientable_loops(a);
  const std::vector<LoopVerdict> judged = judge(a, loops, [&](Halfedge h) {
    ++asked;
    return test->is_hole_right_of(a.geometry(h));
  });
  EXPECT_LT(asked, loops.size()) << "the outer loop needs no question";
  EXPECT_EQ(std::count(judged.begin(), judged.end(), LoopVerdict::boundary), 4 * 4 + 1);
}

TEST(OrientableLoops, turn_clockwise_most_where_chains_touch) {
  // Two squares in a corner: the face outside is to the right of one loop around both.
  const ConvolutionArrangement a(along({box(0, 0, 1, 1), box(1, 1, 2, 2)}));
  const std::vector<OrientableLoop> loops = orientable_loops(a);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 8u);
  // Two holes in a corner: a face each is to the right.
  const ConvolutionArrangement b(along({backwards(box(0, 0, 1, 1)), backwards(box(1, 1, 2, 2))}));
  EXPECT_EQ(orientable_loops(b).size(), 2u);
}

TEST(OrientableLoops, leave_out_edges_of_opposite_segments_and_dead_ends) {
  // A square and its reverse share every edge.
  const ConvolutionArrangement a(along({box(0, 0, 1, 1), backwards(box(0, 0, 1, 1))}));
  EXPECT_TRUE(orientable_loops(a).empty());
  // A path into a loop is not a part of it.
  std::vector<ConvolutionSegment> segments = along({box(0, 0, 1, 1)});
  segments.push_back({{{-1, 0}, {0, 0}}, {}, false});
  const ConvolutionArrangement b(segments);
  const std::vector<OrientableLoop> loops = orientable_loops(b);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 4u);
}

}  // namespace
}  // namespace oplus
