// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "properties/runner/registry.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// How often a vertex passes a direction, turning from `in` to `out` by less than π: 1
/// counterclockwise, -1 clockwise, or 0. The direction is turned by an infinitesimal, as those of Q
/// are, so that no edge has it.
int passed(const Vector& d, const Vector& in, const Vector& out) {
  const auto between = [&](const Vector& from, const Vector& to) {
    return counterclockwise_between({d, Summand::Q}, {from, Summand::P}, {to, Summand::P});
  };
  const int turn = sign(cross(in, out));
  if (turn > 0) return between(in, out) ? 1 : 0;
  if (turn < 0) return between(out, in) ? -1 : 0;
  return 0;
}

/// The axes, two slanted directions, those of the edges, and the opposites of all these.
std::vector<Vector> directions(const std::vector<Segment>& edges) {
  std::vector<Vector> result = {{1, 0}, {0, 1}, {1, 1}, {-2, 1}};
  for (const Segment& e : edges) result.push_back(direction_of(e));
  for (std::size_t i = result.size(); i-- > 0;) result.push_back(-result[i]);
  return result;
}

Outcome check_turning(const Summands& summands) {
  Outcome outcome;
  for (const Region* region : {&summands.p, &summands.q}) {
    for (const Chain& chain : chains(*region)) {
      const std::vector<Segment> of_chain = edges(chain);
      const int expected = sign(twice_area(chain));
      ++outcome.counts[expected > 0 ? "outer chains" : "holes"];
      for (const Vector& d : directions(of_chain)) {
        int turns = 0;
        for (std::size_t i = 0; i < of_chain.size(); ++i)
          turns += passed(d, direction_of(of_chain[i]),
                          direction_of(of_chain[next(i, of_chain.size())]));
        ++outcome.counts["directions"];
        if (turns == expected) continue;
        return outcome.fail("the chain from " + to_string(chain[0]) + " passes the direction " +
                            to_string(d) + " " + std::to_string(turns) + " times instead of " +
                            std::to_string(expected));
      }
    }
  }
  return outcome;
}

const Registered definition_2_1_9(larger_mixture(), {.id = "definition-2.1.9",
                                                     .kills = {"left-and-right-are-one-direction"},
                                                     .cases = 1000,
                                                     .check = check_turning});

/// The sums of an end of one segment and the other segment.
std::vector<Segment> vertex_edge_sums(const Segment& s, const Segment& t) {
  return {{s.source + t.source, s.target + t.source},
          {s.source + t.target, s.target + t.target},
          {s.source + t.source, s.source + t.target},
          {s.target + t.source, s.target + t.target}};
}

/// Where the point a + λ (b - a) + c + μ (d - c) lies, by its parameters.
Location by_parameters(const Rational& lambda, const Rational& mu) {
  if (lambda < 0 || lambda > 1 || mu < 0 || mu > 1) return Location::outside;
  const bool inside = lambda > 0 && lambda < 1 && mu > 0 && mu < 1;
  return inside ? Location::inside : Location::boundary;
}

/// The parallelogram, its interior to the left.
Region parallelogram(const Segment& s, const Segment& t) {
  Chain chain = {s.source + t.source, s.target + t.source, s.target + t.target,
                 s.source + t.target};
  if (sign(cross(direction_of(s), direction_of(t))) < 0) std::reverse(chain.begin(), chain.end());
  return polygon(std::move(chain));
}

std::string defect_of_parallelogram(const Segment& s, const Segment& t, Outcome& outcome) {
  const Region sum = parallelogram(s, t);
  const std::vector<Rational> parameters = {Rational(-1, 2), 0, Rational(1, 3), 1, Rational(3, 2)};
  for (const Rational& lambda : parameters) {
    for (const Rational& mu : parameters) {
      const Point x = s.source + lambda * direction_of(s) + t.source + mu * direction_of(t);
      ++outcome.counts["points in the planes of two edges"];
      if (locate(x, sum) != by_parameters(lambda, mu))
        return to_string(x) + " is not where its parameters say";
      const std::vector<Segment> sides = vertex_edge_sums(s, t);
      const bool on_a_side = std::any_of(sides.begin(), sides.end(),
                                         [&](const Segment& side) { return lies_on(x, side); });
      if (on_a_side != (by_parameters(lambda, mu) == Location::boundary))
        return to_string(x) + " is on a side but not on the boundary, or the other way round";
    }
  }
  return {};
}

std::string defect_of_collinear_sum(const Segment& s, const Segment& t) {
  const std::vector<Segment> sum = maximal_segments(vertex_edge_sums(s, t));
  if (sum.size() != 1) return "the sums of an end and a segment do not form one segment";
  const Vector u = direction_of(s), v = direction_of(t);
  const Vector longest = sign(dot(u, v)) > 0 ? u + v : u - v;
  const Vector found = direction_of(sum[0]);
  return found == longest || found == -longest ? "" : "the sum is not as long as both together";
}

Outcome check_sum_of_two_segments(const Summands& summands) {
  Outcome outcome;
  for (const Segment& s : edges(summands.p)) {
    for (const Segment& t : edges(summands.q)) {
      const bool are_parallel = sign(cross(direction_of(s), direction_of(t))) == 0;
      ++outcome.counts[are_parallel ? "parallel pairs of edges" : "other pairs of edges"];
      const std::string defect =
          are_parallel ? defect_of_collinear_sum(s, t) : defect_of_parallelogram(s, t, outcome);
      if (defect.empty()) continue;
      return outcome.fail("edges from " + to_string(s.source) + " to " + to_string(s.target) +
                          " and from " + to_string(t.source) + " to " + to_string(t.target) + ": " +
                          defect);
    }
  }
  return outcome;
}

const Registered equation_2_1(small_mixture(), {.id = "equation-2.1",
                                                .kills = {"segments-end-to-end-stay-apart"},
                                                .cases = 300,
                                                .check = check_sum_of_two_segments});

}  // namespace

}  // namespace oplus
