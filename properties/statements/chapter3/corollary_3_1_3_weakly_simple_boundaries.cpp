// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "checked/arrangement/rca.hpp"
#include "properties/runner/registry.hpp"
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

Outcome check(const Summands& summands) {
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

const Registered registered(larger_mixture(), {.id = "corollary-3.1.3",
                                               .kills = {"chains-turn-counterclockwise-most"},
                                               .cases = 500,
                                               .check = check});

}  // namespace

}  // namespace oplus
