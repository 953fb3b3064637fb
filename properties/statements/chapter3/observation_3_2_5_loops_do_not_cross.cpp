// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "checked/arrangement/orientable_loops.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

using Arrangement = ConvolutionArrangement;

/// How a loop passes a vertex: the positions of its two edges in clockwise order around the vertex.
using Passage = std::pair<std::size_t, std::size_t>;

bool cross(const Passage& a, const Passage& b) {
  const auto [low, high] = std::minmax(a.first, a.second);
  const auto between = [low = low, high = high](std::size_t i) { return low < i && i < high; };
  return between(b.first) != between(b.second);
}

std::size_t place(const Arrangement& arrangement, Arrangement::Halfedge leaving) {
  std::size_t steps = 0;
  for (Arrangement::Halfedge h = arrangement.leaving(arrangement.source(leaving)); h != leaving;
       h = arrangement.clockwise(h))
    ++steps;
  return steps;
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  const Arrangement arrangement(reduced_convolution(summands.p, summands.q));
  std::set<Arrangement::Halfedge> edges_of_loops;
  std::map<Arrangement::Vertex, std::vector<Passage>> passages;
  const auto fail = [&](Arrangement::Vertex v, const std::string& what) {
    outcome.fail("at " + to_string(arrangement.point(v)) + " " + what, arrangement.point(v));
  };
  for (const OrientableLoop& loop : orientable_loops(arrangement)) {
    ++outcome.counts["loops"];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Arrangement::Halfedge in = loop[i];
      const Arrangement::Halfedge out = loop[next(i, loop.size())];
      const Arrangement::Vertex v = arrangement.target(in);
      if (arrangement.source(out) != v) return fail(v, "a loop is not closed"), outcome;
      if (!edges_of_loops.insert(in).second)
        fail(v, "an edge ends that is on two loops, or twice on one");
      if (edges_of_loops.count(Arrangement::twin(in)) != 0)
        fail(v, "an edge ends that is on loops in both directions");
      passages[v].push_back({place(arrangement, Arrangement::twin(in)), place(arrangement, out)});
    }
  }
  for (const auto& [v, here] : passages) {
    outcome.counts["vertices where loops touch"] += here.size() > 1;
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (cross(here[i], here[j])) fail(v, "loops cross");
  }
  return outcome;
}

const Registered registered(larger_mixture(), {.id = "observation-3.2.5",
                                               .kills = {"loops-go-straight-on"},
                                               .cases = 600,
                                               .check = check});

}  // namespace

}  // namespace oplus
