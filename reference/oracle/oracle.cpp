// SPDX-License-Identifier: MIT
#include "reference/oracle/oracle.hpp"

#include <string>
#include <vector>

#include "reference/definitions/cells.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

/// Whether each cell is in the open sum.
struct CellVerdicts {
  std::vector<bool> faces, edges, vertices;
};

/// Gives every cell its verdict.
class Verdicts {
 public:
  Verdicts(const Region& p, const Region& q, const std::vector<Segment>& convolution)
      : p_(p), q_(q), minus_q_(reflected(q)), convolution_(convolution) {}

  CellVerdicts decide(const Cells& cells) const {
    CellVerdicts in_sum;
    for (const std::vector<Segment>& boundary : cells.faces) {
      if (boundary.empty()) {  // an empty sum: the whole plane is one face
        in_sum.faces.push_back(false);
        continue;
      }
      const Point x = point_inside(boundary);
      in_sum.faces.push_back(interiors_meet_at(x));
      require((winding_number(x, convolution_) > 0) == in_sum.faces.back(), x);
      require((tangent_count(x, p_, q_, {1, 0}) > 0) == in_sum.faces.back(), x);
    }
    for (const Cells::Edge& e : cells.edges) {
      const Point x = midpoint(e.segment.source, e.segment.target);
      in_sum.edges.push_back(interiors_meet_at(x));
      // The sum of the open regions is open.
      require(!in_sum.edges.back() || (in_sum.faces[e.left_face] && in_sum.faces[e.right_face]), x);
    }
    for (const Point& x : cells.vertices) in_sum.vertices.push_back(interiors_meet_at(x));
    return in_sum;
  }

  bool interiors_meet_at(const Point& x) const {
    return interiors_meet(p_, translated(minus_q_, x));
  }

 private:
  static void require(bool agree, const Point& x) {
    if (!agree)
      throw VerdictsDiffer("the oracle's verdicts differ at (" + x.x.get_str() + ", " +
                           x.y.get_str() + ")");
  }

  const Region& p_;
  const Region& q_;
  Region minus_q_;
  const std::vector<Segment>& convolution_;
};

/// Of each vertex, whether all cells around it are in the sum, though it may not be.
std::vector<bool> surrounded(const Cells& cells, const CellVerdicts& in_sum) {
  std::vector<bool> result(cells.vertices.size(), true);
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const Cells::Edge& e = cells.edges[i];
    if (in_sum.edges[i] && in_sum.faces[e.left_face] && in_sum.faces[e.right_face]) continue;
    result[e.source] = false;
    result[e.target] = false;
  }
  return result;
}

/// The same for a point that need not be a vertex of the arrangement.
bool surrounded(const Point& x, const MinkowskiSum& closed, const std::vector<Segment>& dangling) {
  return locate(x, closed) == Location::inside && !lies_on_one(x, dangling);
}

std::vector<Point> vertex_sums(const Region& p, const Region& q) {
  std::vector<Point> sums;
  for (const Segment& e : edges(p))
    for (const Segment& f : edges(q)) sums.push_back(e.source + f.source);
  return sums;
}

}  // namespace

OracleSums oracle_sums(const Region& p, const Region& q) {
  const std::vector<Segment> convolution_segments = segments(convolution(p, q));
  const Cells arrangement = cells(convolution_segments);
  const Verdicts verdicts(p, q, convolution_segments);
  const CellVerdicts in_sum = verdicts.decide(arrangement);

  BoundaryFeatures closed;
  BoundaryFeatures low_dimensional;
  for (std::size_t i = 0; i < arrangement.edges.size(); ++i) {
    const Cells::Edge& e = arrangement.edges[i];
    const bool left = in_sum.faces[e.left_face];
    const bool right = in_sum.faces[e.right_face];
    if (left != right) closed.edges.push_back(left ? e.segment : reversed(e.segment));
    if (left && right && !in_sum.edges[i]) low_dimensional.dangling_edges.push_back(e.segment);
  }
  const std::vector<bool> may_be_isolated = surrounded(arrangement, in_sum);
  for (std::size_t i = 0; i < arrangement.vertices.size(); ++i) {
    if (!in_sum.vertices[i] && may_be_isolated[i])
      low_dimensional.isolated_vertices.push_back(arrangement.vertices[i]);
  }
  low_dimensional.edges = closed.edges;
  const MinkowskiSum closed_sum = canonical_sum(closed);
  // Where chains touch, a sum of two vertices may be isolated though no segment of 𝒞 passes through
  // it, so that it is no vertex of the arrangement (docs/findings.md).
  for (const Point& x : vertex_sums(p, q)) {
    if (!verdicts.interiors_meet_at(x) && surrounded(x, closed_sum, low_dimensional.dangling_edges))
      low_dimensional.isolated_vertices.push_back(x);
  }
  return {closed_sum,
          canonical_sum(low_dimensional),
          {arrangement.faces.size(), arrangement.edges.size(), arrangement.vertices.size()}};
}

MinkowskiSum oracle_sum(const Region& p, const Region& q, Boundary boundary) {
  OracleSums sums = oracle_sums(p, q);
  return boundary == Boundary::closed ? sums.closed : sums.open;
}

}  // namespace oplus
