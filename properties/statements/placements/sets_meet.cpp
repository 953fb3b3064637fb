// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/placements/sets_meet.hpp"

#include <algorithm>

#include "reference/chains/swept_cells.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/cut_at_intersections.hpp"

namespace oplus {

namespace {

std::vector<Segment> all_edges(const ClaimedSum& set) {
  std::vector<Segment> result = edges(set.region);
  result.insert(result.end(), set.dangling_edges.begin(), set.dangling_edges.end());
  return result;
}

std::vector<Point> all_vertices(const ClaimedSum& set) {
  std::vector<Point> result = set.isolated_vertices;
  for (const Segment& e : all_edges(set)) {
    result.push_back(e.source);
    result.push_back(e.target);
  }
  return result;
}

/// Whether a vertex or a point of one is in the region or on an edge of the other, or one of its points.
bool has_vertex_in(const ClaimedSum& a, const ClaimedSum& b) {
  const std::vector<Segment> edges_of_b = all_edges(b);
  const std::vector<Point> vertices = all_vertices(a);
  return std::any_of(vertices.begin(), vertices.end(), [&](const Point& v) {
    return locate(v, b.region) != Location::outside || lies_on_one(v, edges_of_b) ||
           std::find(b.isolated_vertices.begin(), b.isolated_vertices.end(), v) !=
               b.isolated_vertices.end();
  });
}

}  // namespace

bool meet(const ClaimedSum& a, const ClaimedSum& b) {
  for (const Segment& s : all_edges(a))
    for (const Segment& t : all_edges(b))
      if (!intersection(s, t).empty()) return true;
  return has_vertex_in(a, b) || has_vertex_in(b, a);
}

bool interior_meets(const Region& a, const ClaimedSum& b) {
  if (interiors_meet(a, b.region)) return true;
  const auto is_inside = [&](const Point& p) { return locate(p, a) == Location::inside; };
  const std::vector<Segment> of_a = edges(a);
  for (const Segment& s : b.dangling_edges)
    for (const Segment& piece : cut_where_met(s, of_a))
      if (is_inside(midpoint(piece.source, piece.target))) return true;
  return std::any_of(b.isolated_vertices.begin(), b.isolated_vertices.end(), is_inside);
}

ClaimedSum reflected_to(const Point& x, const ClaimedSum& set) {
  ClaimedSum result{mapped(set.region, [&](const Point& p) { return x - p; }), {}, {}};
  for (const Segment& s : set.dangling_edges)
    result.dangling_edges.push_back({x - s.source, x - s.target});
  for (const Point& p : set.isolated_vertices) result.isolated_vertices.push_back(x - p);
  return result;
}

std::vector<Point> points_of_cells(const ClaimedSum& p, const ClaimedSum& q) {
  std::vector<Segment> segments;
  std::vector<Point> points;
  for (const auto& [a, b] : {std::pair(&p, &q), {&q, &p}})
    for (const Point& v : all_vertices(*a))
      for (const Segment& e : all_edges(*b)) segments.push_back({v + e.source, v + e.target});
  for (const Point& v : all_vertices(p))
    for (const Point& w : all_vertices(q)) points.push_back(v + w);
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  const Cells cells = swept_cells(segments);
  points.insert(points.end(), cells.vertices.begin(), cells.vertices.end());
  for (const Cells::Edge& e : cells.edges)
    points.push_back(midpoint(e.segment.source, e.segment.target));
  for (const std::vector<Segment>& face : cells.faces)
    if (!face.empty()) points.push_back(point_inside(face));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace oplus
