// SPDX-License-Identifier: MIT
#include "reference/oracle/set_by_pieces.hpp"

#include <algorithm>
#include <utility>

#include "reference/definitions/cells.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

template <typename Map>
SetByPieces mapped(SetByPieces set, Map map) {
  for (std::vector<Segment>* segments : {&set.boundary, &set.edges})
    for (Segment& s : *segments) s = {map(s.source), map(s.target)};
  for (Point& p : set.points) p = map(p);
  return set;
}

/// Of a point that is on no edge of the boundary.
bool is_inside(const Point& p, const SetByPieces& set) {
  return winding_number(p, set.boundary) + (set.is_unbounded ? 1 : 0) > 0;
}

bool contains_any(const SetByPieces& set, const std::vector<Point>& points) {
  return std::any_of(points.begin(), points.end(), [&](const Point& p) { return set.contains(p); });
}

}  // namespace

bool SetByPieces::contains(const Point& p) const {
  return lies_on_one(p, boundary) || lies_on_one(p, edges) ||
         std::find(points.begin(), points.end(), p) != points.end() || is_inside(p, *this);
}

std::vector<Segment> SetByPieces::all_edges() const {
  std::vector<Segment> all = boundary;
  all.insert(all.end(), edges.begin(), edges.end());
  return all;
}

std::vector<Point> SetByPieces::vertices() const {
  std::vector<Point> all = points;
  for (const Segment& e : all_edges()) {
    all.push_back(e.source);
    all.push_back(e.target);
  }
  return sorted_without_copies(std::move(all));
}

SetByPieces set_by_pieces(const Region& region) {
  return {.boundary = edges(region),
          .is_unbounded = std::any_of(region.components.begin(), region.components.end(),
                                      [](const Component& c) { return c.outer.empty(); })};
}

SetByPieces set_by_pieces(const PlanarSet& value) {
  PlanarSet regular = value;
  regular.dangling_edges.clear();
  return {edges(regular), value.dangling_edges, value.isolated_vertices, value.is_unbounded};
}

SetByPieces path_and_points(const Region& region) {
  SetByPieces result;
  for (const Chain& chain : chains(region)) {
    if (chain.empty()) continue;
    if (!result.edges.empty()) {
      result.points.push_back(chain.front());
    } else {
      result.edges = edges(chain);
      result.edges.pop_back();
    }
  }
  return result;
}

SetByPieces translated(SetByPieces set, const Vector& by) {
  return mapped(std::move(set), [&](const Point& p) { return p + by; });
}

SetByPieces reflected(SetByPieces set) {
  return mapped(std::move(set), [](const Point& p) { return -p; });
}

std::vector<Segment> vertex_edge_sum(const SetByPieces& a, const SetByPieces& b) {
  std::vector<Segment> sums;
  for (const auto& [edges_of, vertices_of] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    const std::vector<Point> vertices = vertices_of->vertices();
    for (const Segment& e : edges_of->all_edges()) {
      for (const Point& v : vertices) {
        Segment sum{e.source + v, e.target + v};
        sums.push_back(sum.source < sum.target ? std::move(sum) : reversed(sum));
      }
    }
  }
  return sorted_without_copies(std::move(sums));
}

bool meet(const SetByPieces& a, const SetByPieces& b) {
  if (a.is_unbounded && b.is_unbounded) return true;
  if (contains_any(b, a.vertices()) || contains_any(a, b.vertices())) return true;
  const std::vector<Segment> edges_of_b = b.all_edges();
  for (const Segment& e : a.all_edges())
    for (const Segment& f : edges_of_b)
      if (!intersection(e, f).empty()) return true;
  return false;
}

bool is_subset(const SetByPieces& a, const SetByPieces& b) {
  // Mostly a vertex shows that it is not.
  for (const Segment& e : a.boundary)
    if (!b.contains(e.source)) return false;
  std::vector<Segment> all = a.boundary;
  all.insert(all.end(), b.boundary.begin(), b.boundary.end());
  const Cells overlay = cells(all);
  return std::all_of(overlay.faces.begin(), overlay.faces.end(), [&](const auto& face) {
    const Point x = face.empty() ? Point{} : point_inside(face);
    return !is_inside(x, a) || is_inside(x, b);
  });
}

}  // namespace oplus
