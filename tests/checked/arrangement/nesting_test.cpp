// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/nesting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "checked/arrangement/hole_test.hpp"
#include "reference/families/pairs.hpp"
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

/// What becomes of boxes one in another, the outermost first, and of which the hole test is asked.
struct Judged {
  std::string verdicts;  ///< b: of the boundary, n: not nested, x: not of the boundary
  std::string asked;     ///< the numbers of boxes, from zero
};

/// The boxes are external loops (e) or holes (h); the hole test finds those numbered in `boundary`.
Judged judged(const std::string& boxes, const std::string& boundary) {
  std::vector<Chain> chains;
  for (const char kind : boxes) {
    const auto number = static_cast<int>(chains.size());
    const Chain chain = box(number, number, 9 - number, 9 - number);
    chains.push_back(kind == 'h' ? backwards(chain) : chain);
  }
  const ConvolutionArrangement a(along(chains));
  const auto number_of = [&](Halfedge h) {
    const Point p = a.point(a.source(h));
    return std::min({p.x, p.y, Rational(9 - p.x), Rational(9 - p.y)}).get_num().get_ui();
  };
  const std::vector<OrientableLoop> loops = orientable_loops(a);
  Judged result{std::string(boxes.size(), ' '), ""};
  const std::vector<LoopVerdict> verdicts = judge(a, loops, [&](Halfedge h) {
    result.asked += std::to_string(number_of(h));
    return boundary.find(result.asked.back()) != std::string::npos;
  });
  for (std::size_t i = 0; i < loops.size(); ++i)
    result.verdicts.at(number_of(loops[i][0])) = "bnx"[static_cast<std::size_t>(verdicts[i])];
  return result;
}

TEST(Nesting, of_boxes_in_each_other) {
  struct Row {
    std::string name, boxes, boundary, verdicts, asked;
  };
  for (const Row& row : {
           Row{"an external loop holds holes that hold external loops", "ehe", "12", "bbb", "12"},
           {"an external loop in an external one is dropped unasked", "ee", "1", "bn", ""},
           {"a hole in a hole is dropped unasked", "ehh", "1", "bbn", "1"},
           {"what is in a fallen loop is judged as its sibling", "ehhe", "23", "bxbb", "123"},
           {"what is in a fallen external loop stays outside", "eheh", "1", "bbxn", "12"},
           {"what is in a loop of the wrong kind stays in the sum", "eeh", "2", "bnb", "2"},
       }) {
    const auto [verdicts, asked] = judged(row.boxes, row.boundary);
    EXPECT_EQ(verdicts, row.verdicts) << row.name;
    EXPECT_EQ(asked, row.asked) << row.name;
  }
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

}  // namespace
}  // namespace oplus
