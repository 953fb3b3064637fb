// SPDX-License-Identifier: GPL-3.0-or-later
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

Outcome check(const Summands& summands) {
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

const Registered registered(larger_mixture(), {.id = "definition-2.1.9",
                                               .kills = {"left-and-right-are-one-direction"},
                                               .cases = 1000,
                                               .check = check});

}  // namespace

}  // namespace oplus
