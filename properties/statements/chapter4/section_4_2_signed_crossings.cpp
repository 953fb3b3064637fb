// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/points_in_faces.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/signed_crossings.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr std::size_t most_paths = 12;  // per pair

std::size_t number_of_crossings(const std::vector<Point>& path, const std::vector<Segment>& all) {
  std::size_t number = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
    if (path[k] != path[k + 1])
      for (const Segment& s : all)
        if (signed_crossing(path[k], path[k + 1], s) != 0) ++number;
  return number;
}

std::string in_words(const std::vector<Point>& path) {
  std::string words;
  for (const Point& p : path) words += (words.empty() ? "" : " to ") + to_string(p);
  return words;
}

void expect(const std::vector<Point>& path, const std::vector<Segment>& all, Outcome& outcome) {
  const int before = winding_number(path.front(), all), after = winding_number(path.back(), all);
  const int sum = signed_crossings(path, all);
  ++outcome.counts["paths"];
  outcome.counts["crossings"] += number_of_crossings(path, all);
  if (before != after) ++outcome.counts["paths that change the winding number"];
  if (sum == after - before) return;
  outcome.fail("from " + in_words(path) + " the winding number goes from " +
               std::to_string(before) + " to " + std::to_string(after) +
               ", and signed crossings add up to " + std::to_string(sum));
}

Outcome check_signed_crossings(const Summands& summands) {
  const std::vector<Segment> all = segments(convolution(summands.p, summands.q));
  const std::vector<Point> points = points_in_faces(all, {});
  const std::size_t paths = std::min(points.size(), most_paths);
  Outcome outcome;
  for (std::size_t k = 0; k < paths && outcome.kind == Outcome::Kind::holds; ++k) {
    const Point& from = points[k * points.size() / paths];
    const Point& to = points[(k + 1) % paths * points.size() / paths];
    const Segment& along = all[k * all.size() / paths];
    expect({from, to}, all, outcome);
    if (outcome.kind == Outcome::Kind::holds)
      expect({from, along.source, along.target, to}, all, outcome);
    if (outcome.kind == Outcome::Kind::holds) expect({from, along.target, to, from}, all, outcome);
  }
  return outcome;
}

const Registered observation_4_2_5(small_mixture(),
                                   {.id = "observation-4.2.5",
                                    .kills = {"ray-counts-both-ends", "steps-are-not-shifted",
                                              "tangent-set-without-ties", "reflex-turns-clockwise"},
                                    .cases = 150,
                                    .check = check_signed_crossings});

constexpr std::size_t most_segments = 60;  // per pair

bool lies_inside(const Point& p, const Segment& s) {
  return p != s.source && p != s.target && lies_on(p, s);
}

const Point& vertex_of(const std::vector<Chain>& all, const VertexIndex& v) {
  return all[v.chain][v.vertex];
}

Segment edge_of(const std::vector<Chain>& all, const VertexIndex& e) {
  const Chain& chain = all[e.chain];
  return {chain[e.vertex], chain[next(e.vertex, chain.size())]};
}

/// Whether the vertex that the origin names is inside the edge that it names, in P and -Q+x, whose
/// chains are in the order of Q's.
bool meet_as_named(const Origin& origin, const std::vector<Chain>& of_p,
                   const std::vector<Chain>& placed) {
  return origin.edge_of == Summand::P
             ? lies_inside(vertex_of(placed, origin.vertex), edge_of(of_p, origin.edge))
             : lies_inside(vertex_of(of_p, origin.vertex), edge_of(placed, origin.edge));
}

/// The number of pairs of a vertex of one region and an edge of the other with the vertex inside
/// the edge.
std::size_t vertices_inside_edges(const Region& vertices_of, const Region& edges_of) {
  std::size_t count = 0;
  for (const Segment& e : edges(edges_of))
    for (const Chain& chain : chains(vertices_of))
      count += static_cast<std::size_t>(std::count_if(
          chain.begin(), chain.end(), [&](const Point& v) { return lies_inside(v, e); }));
  return count;
}

Outcome check_vertex_on_edge(const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<Chain> of_p = chains(p);
  const std::vector<ConvolutionSegment> all = convolution(p, q), sums = vertex_edge_sum(p, q);
  const Region turned = reflected(q);
  const std::size_t looked_at = std::min(all.size(), most_segments);
  Outcome outcome;
  for (std::size_t k = 0; k < looked_at; ++k) {
    const auto& [segment, origin, corner] = all[k * all.size() / looked_at];
    for (const Rational& t : {Rational(1, 2), Rational(13, 31)}) {
      const Point x = segment.source + t * direction_of(segment);
      const Region placed = translated(turned, x);
      const std::size_t met = vertices_inside_edges(p, placed) + vertices_inside_edges(placed, p);
      const auto through = static_cast<std::size_t>(std::count_if(
          sums.begin(), sums.end(), [&](const auto& s) { return lies_inside(x, s.segment); }));
      ++outcome.counts["points"];
      outcome.counts["vertices inside edges"] += met;
      if (!meet_as_named(origin, of_p, chains(placed)))
        outcome.why = "the named vertex is not inside the named edge";
      else if (met != through)
        outcome.why =
            "vertices inside edges: " + std::to_string(met) +
            ", segments of the vertex-edge sum with the point inside: " + std::to_string(through);
      if (outcome.why.empty()) continue;
      return outcome.fail("at " + to_string(x) + " " + outcome.why, x);
    }
  }
  return outcome;
}

const Registered observation_4_2_8(small_mixture(), {.id = "observation-4.2.8",
                                                     .kills = {"sums-name-the-vertex-before"},
                                                     .cases = 100,
                                                     .check = check_vertex_on_edge});

/// So many of all, from beginning to end.
template <typename T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t most) {
  const std::size_t n = std::min(all.size(), most);
  std::vector<T> result;
  for (std::size_t k = 0; k < n; ++k) result.push_back(all[k * all.size() / n]);
  return result;
}

/// A chain with neighbours exchanged: it may cross itself, or go round clockwise.
Chain entangled(Chain chain) {
  for (std::size_t i = 1; i + 1 < chain.size(); i += 3) std::swap(chain[i], chain[i + 1]);
  return chain;
}

Region entangled(Region region) {
  for (Component& component : region.components) {
    component.outer = entangled(component.outer);
    for (Chain& hole : component.holes) hole = entangled(hole);
  }
  return region;
}

void expect(const Summands& pair, Outcome& outcome) {
  const std::vector<Segment> all = segments(convolution(pair.p, pair.q));
  std::vector<Point> points = some_of(points_in_faces(all, {}), 12);
  for (const Segment& s : some_of(all, 6)) {
    points.push_back(s.source);
    points.push_back(midpoint(s.source, s.target));
  }
  std::vector<Vector> directions{{1, 0}, {-1, 0}, {3, -7}};
  for (const Region* const summand : {&pair.p, &pair.q})
    for (const Segment& e : some_of(edges(*summand), 2)) {
      directions.push_back(direction_of(e));
      directions.push_back(-direction_of(e));
    }
  for (const Point& x : points) {
    const int winding = winding_number(x, all);
    ++outcome.counts["points"];
    if (winding != 0) ++outcome.counts["points with a winding number other than zero"];
    for (const Vector& d : directions) {
      const int count = tangent_count(x, pair.p, pair.q, d);
      if (count == winding) continue;
      outcome.fail("the winding number is " + std::to_string(winding) + ", and " +
                       std::to_string(count) + " corners have the tangent direction " +
                       to_string(Point{d.x, d.y}),
                   x);
      return;
    }
  }
}

Outcome check_tangent_count(const Summands& summands) {
  Outcome outcome;
  for (const Summands& pair : {summands, Summands{entangled(summands.p), summands.q},
                               Summands{entangled(summands.p), entangled(summands.q)}})
    if (outcome.kind == Outcome::Kind::holds) expect(pair, outcome);
  return outcome;
}

const Registered fact_tangent_count(
    small_mixture(),
    {
        .id = "fact-tangent-count",
        .kills = {"crossings-count-with-a-sign", "tie-rule-depends-on-who-asks",
                  "tangent-set-without-ties", "reflex-turns-clockwise", "ray-counts-both-ends"},
        .cases = 100,
        .check = check_tangent_count,
    });

}  // namespace

}  // namespace oplus
