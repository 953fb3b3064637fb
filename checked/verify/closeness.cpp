// SPDX-License-Identifier: MIT
#include "checked/verify/closeness.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <utility>

#include "checked/verify/near_boundary.hpp"
#include "checked/verify/overlay.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::vector<Segment> with_points(std::vector<Segment> all, const std::vector<Point>& points) {
  for (const Point& p : points) all.push_back({p, p});
  return all;
}

std::vector<Segment> boundary_of(const PlanarSet& sum) {
  return with_points(edges(sum), sum.isolated_vertices);
}

std::vector<Segment> boundary_of(const ClaimedSum& sum) {
  std::vector<Segment> all = edges(sum.region);
  all.insert(all.end(), sum.dangling_edges.begin(), sum.dangling_edges.end());
  return with_points(std::move(all), sum.isolated_vertices);
}

/// Where boxes differ by more, so do chains.
bool boxes_within(const ExactBox& a, const ExactBox& b, const Rational& distance) {
  return abs(a.low.x - b.low.x) <= distance && abs(a.low.y - b.low.y) <= distance &&
         abs(a.high.x - b.high.x) <= distance && abs(a.high.y - b.high.y) <= distance;
}

std::string described(const Chain& chain, bool is_hole) {
  return (is_hole ? "the hole at " : "the component at ") +
         to_string(*std::min_element(chain.begin(), chain.end()));
}

struct Partner {
  explicit Partner(const Chain& chain)
      : edges(oplus::edges(chain)), box(box_around(edges)), tree(edges) {}

  std::vector<Segment> edges;
  ExactBox box;
  SegmentTree tree;
};

std::vector<Partner> partners(const std::vector<Chain>& chains) {
  return {chains.begin(), chains.end()};
}

/// Pairs as many chains as possible, and names the others.
void find_partners(const std::vector<Chain>& right, const std::vector<Chain>& given,
                   const Rational& tolerance, bool are_holes, std::vector<std::string>& left_over) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  Graph graph(right.size() + given.size());
  const std::vector<Partner> of_right = partners(right);
  const std::vector<Partner> of_given = partners(given);
  std::vector<Segment> corners;
  for (const Partner& one : of_given) corners.push_back({one.box.low, one.box.low});
  const SegmentTree by_corner(std::move(corners));
  const Rational squared = tolerance * tolerance;
  const double most = interval(2 * squared).high;
  for (std::size_t i = 0; i < right.size(); ++i) {
    const Partner& one = of_right[i];
    const Box corner = box_of(interval(one.box.low));
    std::vector<std::size_t> candidates;
    by_corner.look_for(
        most, [&](const Box& box) { return squared_gap(corner, box); },
        [&](std::size_t j) {
          if (boxes_within(one.box, of_given[j].box, tolerance)) candidates.push_back(j);
          return most;
        });
    std::sort(candidates.begin(), candidates.end());
    for (const std::size_t j : candidates)
      if (is_within(one.edges, of_given[j].tree, squared) &&
          is_within(of_given[j].edges, one.tree, squared))
        boost::add_edge(i, right.size() + j, graph);
  }
  std::vector<Graph::vertex_descriptor> mate(boost::num_vertices(graph));
  if (!mate.empty()) boost::edmonds_maximum_cardinality_matching(graph, mate.data());
  for (std::size_t i = 0; i < mate.size(); ++i) {
    if (mate[i] != Graph::null_vertex()) continue;
    const bool is_right = i < right.size();
    left_over.push_back(
        described(is_right ? right[i] : given[i - right.size()], are_holes) +
        (is_right ? " of the sum has no partner" : " that is given has no partner"));
  }
}

struct ChainsByKind {
  explicit ChainsByKind(const Region& region) {
    for (const Component& component : region.components) {
      outer.push_back(component.outer);
      holes.insert(holes.end(), component.holes.begin(), component.holes.end());
    }
  }

  std::vector<Chain> outer;
  std::vector<Chain> holes;
};

}  // namespace

Closeness closeness(const PlanarSet& right, const ClaimedSum& sum, const Rational& tolerance) {
  Closeness result{};
  const std::vector<Segment> of_right = boundary_of(right);
  const std::vector<Segment> of_given = boundary_of(sum);
  const Rational squared = tolerance * tolerance;
  if (of_right.empty() || of_given.empty()) {
    result.is_within = of_right.empty() && of_given.empty();
    if (result.is_within) result.distance = BoundaryDistance{0, 0, {}, false};
  } else {
    result.distance = distance(of_right, of_given);
    result.is_within = result.distance->most_squared <= squared;
    // Bounds on either side of D decide nothing.
    if (!result.is_within && result.distance->least_squared <= squared)
      result.is_within =
          is_within(of_right, of_given, squared) && is_within(of_given, of_right, squared);
  }

  const Overlay overlay(sum, {});
  const ChainsByKind of_right_region(region_of(right));
  const ChainsByKind of_given_region(
      region_of(canonical_sum(BoundaryFeatures{overlay.boundary_of_given(), {}, {}})));
  find_partners(of_right_region.outer, of_given_region.outer, tolerance, false, result.no_partners);
  find_partners(of_right_region.holes, of_given_region.holes, tolerance, true, result.no_partners);
  if (result.is_within && result.distance)
    result.distance->most_squared = std::min(result.distance->most_squared, squared);
  const std::size_t unsimple = overlay.unsimple_pieces().size();
  if (!result.has_same_chains())
    result.differs_near_boundary_only =
        (of_given.empty() || is_within(of_given, of_right, squared)) &&
        differs_near_only(right, sum, of_given, tolerance);
  if (result.is_distance_of_given() && result.distance) {
    result.distance = distance_of_given(of_right, of_given);
    result.distance->most_squared = std::min(result.distance->most_squared, squared);
  }
  if (unsimple > 0)
    result.notes.push_back("chains cross, overlap or bound nothing in " +
                           counted(unsimple, "place", "places"));
  return result;
}

}  // namespace oplus
