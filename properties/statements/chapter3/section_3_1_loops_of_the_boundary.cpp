// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/nesting.hpp"
#include "checked/arrangement/orientable_loops.hpp"
#include "checked/arrangement/rca.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Where a chain passes a point: it comes along `in` and goes on along `out`.
struct Pass {
  Vector in;
  Vector out;
};

/// Whether d, from the vertex, points to the right of the pass.
bool is_right_of(const Vector& d, const Pass& pass) {
  return counterclockwise_between({d, Summand::P}, {-pass.in, Summand::P}, {pass.out, Summand::P});
}

/// All passes at each point: at vertices, and where a chain touches an edge inside.
std::map<Point, std::vector<Pass>> passes_of(const PlanarSet& sum,
                                             const std::vector<std::vector<Segment>>& pieces) {
  std::map<Point, std::vector<Pass>> passes;
  std::size_t edge = 0;
  for (const std::vector<Chain>* of_sum : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *of_sum) {
      std::vector<Segment> around;
      for (std::size_t i = 0; i < chain.size(); ++i, ++edge)
        around.insert(around.end(), pieces[edge].begin(), pieces[edge].end());
      for (std::size_t k = 0; k < around.size(); ++k)
        passes[around[k].target].push_back(
            {direction_of(around[k]), direction_of(around[next(k, around.size())])});
    }
  }
  return passes;
}

std::string defect_of(const Point& at, const std::vector<Pass>& passes) {
  for (const Pass& pass : passes) {
    if (same_direction(-pass.in, pass.out)) return "at " + to_string(at) + " a chain turns back";
    for (const Pass& another : passes) {
      if (&another == &pass) continue;
      for (const Vector& d : {Vector(-another.in), another.out}) {
        if (is_right_of(d, pass))
          return "at " + to_string(at) + " a chain has another part of the boundary to its right";
        if (same_direction(d, pass.out) || same_direction(d, -pass.in))
          return "at " + to_string(at) + " edges overlap";
      }
    }
  }
  return {};
}

Outcome check_weakly_simple_boundaries(const Summands& summands) {
  const PlanarSet sum = rca(summands.p, summands.q, Boundary::closed).sum;
  const std::vector<Segment> all = edges(sum);
  Outcome outcome;
  for (const auto& [at, passes] : passes_of(sum, cut_at_intersections(all))) {
    ++outcome.counts[passes.size() > 1 ? "points where the boundary touches itself"
                                       : "other vertices"];
    const std::string defect = defect_of(at, passes);
    if (defect.empty()) continue;
    return outcome.fail(defect, at);
  }
  return outcome;
}

const Registered corollary_3_1_3(larger_mixture(), {.id = "corollary-3.1.3",
                                                    .kills = {"chains-turn-counterclockwise-most"},
                                                    .cases = 500,
                                                    .check = check_weakly_simple_boundaries});

using Arrangement = ConvolutionArrangement;

/// Compares the filters' verdict on each loop with the definition of the sum. If two boundary loops
/// of one kind were directly inside each other, the filters would discard one of them.
Outcome check_nesting(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  const Arrangement arrangement(reduced_convolution(summands.p, summands.q));
  const auto is_boundary = [&](Arrangement::Halfedge h) {
    const Segment edge = arrangement.geometry(h);
    return !open_sum.contains(midpoint(edge.source, edge.target));
  };
  const std::vector<OrientableLoop> loops = orientable_loops(arrangement);
  const std::vector<LoopVerdict> verdicts = judge(arrangement, loops, is_boundary);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const bool expected = is_boundary(loops[i][0]);
    outcome.counts["loops on the boundary"] += expected;
    outcome.counts["other loops"] += !expected;
    outcome.counts["loops that are not nested"] += verdicts[i] == LoopVerdict::not_nested;
    if ((verdicts[i] == LoopVerdict::boundary) == expected) continue;
    const Point at = arrangement.point(arrangement.source(loops[i][0]));
    outcome.fail("the loop through " + to_string(at) +
                     (expected ? " is on the boundary, and the filters discard it"
                               : " is not on the boundary, and the filters keep it"),
                 at);
  }
  return outcome;
}

const Registered observation_3_1_4({
    .id = "observation-3.1.4",
    .sources = {{"grid", 8, 4},
                {"tight", 4, 2},
                {"holes", 6, 3},
                {"components", 5, 2},
                {"islands", 3, 3},
                {"fork", 2, 1},
                {"comb", 3, 1}},
    .promises = usual_promises(),
    .kills = {"islands-are-not-nested", "nested-loops-need-no-hole-test"},
    .cases = 300,
    .check = check_nesting,
});

Outcome check_one_test_per_loop(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  const ConvolutionArrangement arrangement(reduced_convolution(summands.p, summands.q));
  const std::vector<OrientableLoop> loops = orientable_loops(arrangement);
  for (const auto& [name, method] : hole_test_methods()) {
    const auto test = method(summands.p, summands.q);
    for (const OrientableLoop& loop : loops) {
      const bool of_loop = test->is_hole_right_of(arrangement.geometry(loop[0]));
      outcome.counts[of_loop ? "edges of loops on the boundary" : "edges of other loops"] +=
          loop.size();
      for (const ConvolutionArrangement::Halfedge h : loop) {
        const Segment edge = arrangement.geometry(h);
        const Point middle = midpoint(edge.source, edge.target);
        const bool collides = open_sum.contains(middle);
        if (collides != of_loop && test->is_hole_right_of(edge) == of_loop) continue;
        return outcome.fail("hole test " + name + " and the definition differ on the edge from " +
                                to_string(edge.source) + " to " + to_string(edge.target) +
                                " of a loop",
                            middle);
      }
    }
  }
  return outcome;
}

const Registered observation_3_1_5(small_mixture(), {.id = "observation-3.1.5",
                                                     .kills = {"rays-start-left-of-their-edge"},
                                                     .cases = 300,
                                                     .check = check_one_test_per_loop});

}  // namespace

}  // namespace oplus
