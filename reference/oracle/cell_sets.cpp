// SPDX-License-Identifier: MIT
#include "reference/oracle/cell_sets.hpp"

#include "reference/definitions/verdicts_differ.hpp"

namespace oplus {

BoundaryFeatures features_of(const Cells& cells, const CellVerdicts& in_set, Boundary boundary) {
  // An open set, or the complement of a closed one: where a cell is in that, so is all around it.
  const auto is_in_open = [&](bool is_in) { return is_in == (boundary == Boundary::open); };
  const auto require = [&](bool is_surrounded, const Point& x) {
    if (!is_surrounded)
      throw VerdictsDiffer(std::string("the set is not ") +
                           (boundary == Boundary::open ? "open" : "closed") + " at (" +
                           x.x.get_str() + ", " + x.y.get_str() + ")");
  };
  BoundaryFeatures features;
  std::vector<bool> is_surrounded(cells.vertices.size(), true);
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const Cells::Edge& e = cells.edges[i];
    const bool left = in_set.faces[e.left_face], right = in_set.faces[e.right_face];
    if (left != right) features.edges.push_back(left ? e.segment : reversed(e.segment));
    const bool are_faces = is_in_open(left) && is_in_open(right);
    if (is_in_open(in_set.edges[i])) {
      require(are_faces, midpoint(e.segment.source, e.segment.target));
      continue;
    }
    if (are_faces) features.dangling_edges.push_back(e.segment);
    is_surrounded[e.source] = false;
    is_surrounded[e.target] = false;
  }
  for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
    if (is_in_open(in_set.vertices[i]))
      require(is_surrounded[i], cells.vertices[i]);
    else if (is_surrounded[i])
      features.isolated_vertices.push_back(cells.vertices[i]);
  }
  return features;
}

PlanarSet set_where(const std::vector<Segment>& segments, Boundary boundary,
                    const std::function<bool(const Point&)>& contains) {
  const Cells arrangement = cells(segments);
  CellVerdicts in_set;
  for (const std::vector<Segment>& face : arrangement.faces)  // without a boundary: the plane
    in_set.faces.push_back(contains(face.empty() ? Point{} : point_inside(face)));
  for (const Cells::Edge& e : arrangement.edges)
    in_set.edges.push_back(contains(midpoint(e.segment.source, e.segment.target)));
  for (const Point& x : arrangement.vertices) in_set.vertices.push_back(contains(x));
  PlanarSet set = canonical_sum(features_of(arrangement, in_set, boundary));
  set.is_unbounded = in_set.faces[arrangement.unbounded_face];
  return set;
}

}  // namespace oplus
