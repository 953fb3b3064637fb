// SPDX-License-Identifier: MIT
#include "reference/oracle/oracle.hpp"

#include <vector>

#include "reference/definitions/cells.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/oracle/cell_sets.hpp"

namespace oplus {

namespace {

/// Gives every cell its verdict: whether it is in the open sum.
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
    for (const Cells::Edge& e : cells.edges)
      in_sum.edges.push_back(interiors_meet_at(midpoint(e.segment.source, e.segment.target)));
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

/// Whether all around a point is in the open sum, though the point may not be.
bool surrounded(const Point& x, const PlanarSet& closed, const std::vector<Segment>& dangling) {
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

  BoundaryFeatures open = features_of(arrangement, in_sum, Boundary::open);
  const PlanarSet closed_sum = canonical_sum(BoundaryFeatures{open.edges, {}, {}});
  // That isolated vertices are on segments of 𝒞 is Theorem 2.2.10. The oracle does not rely on it: it
  // tries all sums of two vertices.
  for (const Point& x : vertex_sums(p, q)) {
    if (!verdicts.interiors_meet_at(x) && surrounded(x, closed_sum, open.dangling_edges))
      open.isolated_vertices.push_back(x);
  }
  return {closed_sum,
          canonical_sum(open),
          {arrangement.faces.size(), arrangement.edges.size(), arrangement.vertices.size()}};
}

PlanarSet oracle_sum(const Region& p, const Region& q, Boundary boundary) {
  OracleSums sums = oracle_sums(p, q);
  return boundary == Boundary::closed ? sums.closed : sums.open;
}

}  // namespace oplus
