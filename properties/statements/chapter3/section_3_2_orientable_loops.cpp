// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/nesting.hpp"
#include "checked/arrangement/orientable_loops.hpp"
#include "checked/arrangement/rca.hpp"
#include "checked/arrangement/sum_by_loops.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/covered_sum.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/writing.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome check_orientable_loops(const Summands& summands) {
  Outcome outcome;
  const PlanarSet sum = oracle_sum(summands.p, summands.q, Boundary::closed);
  const std::vector<ConvolutionSegment> reduced = reduced_convolution(summands.p, summands.q);
  for (const Segment& edge : edges(sum)) {
    ++outcome.counts["edges of the boundary"];
    std::vector<Segment> along;
    for (const ConvolutionSegment& s : reduced) {
      if (!overlap(s.segment, edge)) continue;
      if (same_direction(direction_of(s.segment), direction_of(edge))) {
        along.push_back(s.segment);
        continue;
      }
      outcome.fail("a segment runs against the edge from " + to_string(edge.source) + " to " +
                       to_string(edge.target),
                   midpoint(edge.source, edge.target));
    }
    if (cover(along, edge)) continue;
    outcome.fail("no segments run along all of the edge from " + to_string(edge.source) + " to " +
                     to_string(edge.target),
                 midpoint(edge.source, edge.target));
  }
  if (const auto found =
          difference(sum_by_loops(summands.p, summands.q, Boundary::closed).sum, sum))
    outcome.fail("the sum by loops is not the oracle's: " + found->what, found->witness);
  return outcome;
}

const Registered lemma_3_1_2(small_mixture(), {.id = "lemma-3.1.2",
                                               .kills = {"loops-turn-counterclockwise-most"},
                                               .cases = 80,
                                               .check = check_orientable_loops});

bool equal(const ConvolutionSegment& a, const ConvolutionSegment& b) {
  return a.origin == b.origin && a.segment == b.segment && a.vertex_is_reflex == b.vertex_is_reflex;
}

bool equal_as_multisets(std::vector<ConvolutionSegment> a, std::vector<ConvolutionSegment> b) {
  // Origins are distinct, so this order is the only one.
  for (std::vector<ConvolutionSegment>* segments : {&a, &b})
    std::ranges::sort(*segments, {}, &ConvolutionSegment::origin);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

bool are_origins_of(const std::vector<ConvolutionSegment>& segments,
                    const std::vector<TracedOrigin>& origins) {
  return std::equal(segments.begin(), segments.end(), origins.begin(), origins.end(),
                    [](const ConvolutionSegment& s, const TracedOrigin& o) {
                      return s.origin == o.origin && s.vertex_is_reflex == o.vertex_is_reflex;
                    });
}

Outcome check_traced_convolution(const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<ConvolutionSegment> full = convolution(p, q);
  const std::vector<ConvolutionSegment> reduced = reduced_convolution(p, q);
  const ConvolutionCycles cycles = convolution_cycles(p, q);
  const std::vector<ConvolutionSegment> traced = traced_convolution(p, q);
  Outcome outcome;
  outcome.counts = {{"segments of the full convolution", full.size()},
                    {"segments of the reduced convolution", reduced.size()}};
  if (!equal_as_multisets(full_convolution(cycles), full))
    outcome.why = "the cycles' segments are not the convolution";
  else if (!equal_as_multisets(reduced_convolution(cycles), reduced))
    outcome.why = "the cycles' segments without reflex vertices are not the reduced convolution";
  else if (!equal_as_multisets(traced, full))
    outcome.why = "the segments traced one by one are not the convolution";
  else if (!equal_as_multisets(traced_reduced_convolution(p, q), reduced))
    outcome.why =
        "the segments traced one by one, without reflex vertices, are not the reduced "
        "convolution";
  else if (!are_origins_of(traced, traced_origins(p, q)))
    outcome.why = "tracing without points gives other segments";
  if (!outcome.why.empty()) outcome.kind = Outcome::Kind::fails;
  return outcome;
}

const Registered section_3_2_1(
    larger_mixture(), {
                          .id = "section-3.2.1",
                          .kills = {"filtered-ties-the-other-way", "no-start-in-the-first-column",
                                    "reflex-where-angles-decrease", "tie-rule-depends-on-who-asks",
                                    "tangent-set-without-ties", "reflex-turns-clockwise"},
                          .cases = 1500,
                          .check = check_traced_convolution,
                      });

using Arrangement = ConvolutionArrangement;
using Halfedge = Arrangement::Halfedge;

/// Counts what the filters discard; a loop that the nesting filter discards must not be on the
/// boundary.
void look_at_loops(const Summands& summands, Outcome& outcome) {
  const ConvolutionArrangement arrangement(
      reduced_convolution(convolution_cycles(summands.p, summands.q)));
  const auto test = hierarchy_hole_test(summands.p, summands.q);
  const auto is_hole_right_of = [&](Halfedge h) {
    return test->is_hole_right_of(arrangement.geometry(h));
  };
  const std::vector<OrientableLoop> loops = orientable_loops(arrangement);
  const std::vector<LoopVerdict> verdicts = judge(arrangement, loops, is_hole_right_of);
  outcome.counts["orientable loops"] += loops.size();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    outcome.counts["loops on the boundary"] += verdicts[i] == LoopVerdict::boundary;
    outcome.counts["loops that a hole test discards"] += verdicts[i] == LoopVerdict::not_boundary;
    if (verdicts[i] != LoopVerdict::not_nested) continue;
    ++outcome.counts["loops that the nesting filter discards"];
    if (!is_hole_right_of(loops[i][0])) continue;
    outcome.fail("the nesting filter discards a loop on the boundary");
  }
}

Outcome check_loops_and_faces(const Summands& summands) {
  Outcome outcome;
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const auto found = difference(rca(summands.p, summands.q, boundary).sum,
                                  sum_by_loops(summands.p, summands.q, boundary).sum);
    if (found)
      return outcome.fail("faces give the first sum, loops the second: " + found->what,
                          found->witness);
  }
  look_at_loops(summands, outcome);
  return outcome;
}

const Registered section_3_2_3({
    .id = "section-3.2.3",
    .sources = {{"grid", 8, 4},
                {"tight", 6, 2},
                {"holes", 6, 3},
                {"components", 5, 2},
                {"islands", 3, 2},
                {"fork", 4, 2},
                {"comb", 4, 1},
                {"star", 16, 1},
                {"simple", 12, 1}},
    .promises = usual_promises(),
    .kills = {"candidates-need-no-hole-test", "islands-are-not-nested",
              "loops-turn-counterclockwise-most"},
    .cases = 600,
    .check = check_loops_and_faces,
});

/// Where all segments have one direction, the sum is to their left; so such an edge is on the
/// boundary of the closed sum iff the points inside it are not in the open sum.
Outcome check_tracing_stays_on_the_boundary(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  const Arrangement arrangement(reduced_convolution(summands.p, summands.q));
  const auto is_boundary = [&](Halfedge h) {
    const Segment edge = arrangement.geometry(h);
    return !open_sum.contains(midpoint(edge.source, edge.target));
  };
  const auto fail = [&](Halfedge h, const std::string& what) {
    const Segment edge = arrangement.geometry(h);
    outcome.fail("from " + to_string(edge.source) + " to " + to_string(edge.target) + " " + what,
                 midpoint(edge.source, edge.target));
  };
  std::set<Halfedge> on_loops;
  for (const OrientableLoop& loop : orientable_loops(arrangement)) {
    const bool first = is_boundary(loop[0]);
    ++outcome.counts[first ? "loops on the boundary" : "other loops"];
    for (const Halfedge h : loop) {
      on_loops.insert(h);
      if (is_boundary(h) != first) fail(h, "a loop leaves or enters the boundary");
    }
  }
  for (Halfedge h = 0; h < 2 * arrangement.edge_count(); ++h) {
    const bool one_way =
        !arrangement.along(h).empty() && arrangement.along(Arrangement::twin(h)).empty();
    if (one_way && on_loops.count(h) == 0 && is_boundary(h)) fail(h, "the boundary is on no loop");
  }
  return outcome;
}

const Registered observation_3_2_4(small_mixture(), {.id = "observation-3.2.4",
                                                     .kills = {"loops-turn-counterclockwise-most"},
                                                     .cases = 400,
                                                     .check = check_tracing_stays_on_the_boundary});

/// How a loop passes a vertex: the positions of its two edges in clockwise order around the vertex.
using Passage = std::pair<std::size_t, std::size_t>;

bool cross(const Passage& a, const Passage& b) {
  const auto [low, high] = std::minmax(a.first, a.second);
  const auto between = [low = low, high = high](std::size_t i) { return low < i && i < high; };
  return between(b.first) != between(b.second);
}

std::size_t place(const Arrangement& arrangement, Halfedge leaving) {
  std::size_t steps = 0;
  for (Halfedge h = arrangement.leaving(arrangement.source(leaving)); h != leaving;
       h = arrangement.clockwise(h))
    ++steps;
  return steps;
}

Outcome check_loops_do_not_cross(const Summands& summands) {
  Outcome outcome;
  const Arrangement arrangement(reduced_convolution(summands.p, summands.q));
  std::set<Halfedge> edges_of_loops;
  std::map<Arrangement::Vertex, std::vector<Passage>> passages;
  const auto fail = [&](Arrangement::Vertex v, const std::string& what) {
    outcome.fail("at " + to_string(arrangement.point(v)) + " " + what, arrangement.point(v));
  };
  for (const OrientableLoop& loop : orientable_loops(arrangement)) {
    ++outcome.counts["loops"];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Halfedge in = loop[i];
      const Halfedge out = loop[next(i, loop.size())];
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

const Registered observation_3_2_5(larger_mixture(), {.id = "observation-3.2.5",
                                                      .kills = {"loops-go-straight-on"},
                                                      .cases = 600,
                                                      .check = check_loops_do_not_cross});

}  // namespace

}  // namespace oplus
