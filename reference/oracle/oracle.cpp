// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle/oracle.hpp"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mpq_class.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "reference/definitions/collision.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

// Plain rationals: no filter, no lazy evaluation. Each cell carries whether it is in the open sum.
using Traits = CGAL::Arr_segment_traits_2<CGAL::Simple_cartesian<Rational>>;
using Cells = CGAL::Arr_extended_dcel<Traits, bool, bool, bool>;
using Arrangement = CGAL::Arrangement_2<Traits, Cells>;

Point point(const Traits::Point_2& p) { return {p.x(), p.y()}; }

template <typename Halfedge>
Segment segment(Halfedge e) {
  return {point(e->source()->point()), point(e->target()->point())};
}

/// Cuts the segments into pieces that meet in common ends only, so that CGAL has but to connect
/// them: its sweep, in 5.5, fails on some overlaps (docs/findings.md).
Arrangement arrangement_of(const std::vector<Segment>& segments) {
  std::set<Segment> pieces;
  for (const std::vector<Segment>& of_segment : cut_at_intersections(segments)) {
    for (const Segment& piece : of_segment)
      pieces.insert(piece.source < piece.target ? piece : reversed(piece));
  }
  std::vector<Traits::X_monotone_curve_2> curves;
  for (const Segment& s : pieces)
    curves.emplace_back(Traits::Point_2(s.source.x, s.source.y),
                        Traits::Point_2(s.target.x, s.target.y));
  Arrangement arrangement;
  CGAL::insert_non_intersecting_curves(arrangement, curves.begin(), curves.end());
  return arrangement;
}

/// All edges of a face's boundary, the face to their left.
std::vector<Segment> boundary(Arrangement::Face_handle face) {
  std::vector<Segment> result;
  const auto add = [&](Arrangement::Ccb_halfedge_circulator first) {
    auto e = first;
    do {
      result.push_back(segment(e));
    } while (++e != first);
  };
  for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) add(*ccb);
  for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) add(*ccb);
  return result;
}

/// A point inside a face: from the middle of an edge to the left, half way to what is met first.
Point point_inside(const std::vector<Segment>& boundary) {
  const Point start = midpoint(boundary[0].source, boundary[0].target);
  const Vector along = direction_of(boundary[0]);
  const Vector left{-along.y, along.x};
  Rational step = 2;  // in the unbounded face, where nothing may be met
  const auto meet = [&](const Rational& at) {
    if (at > 0 && at < step) step = at;
  };
  for (const Segment& e : boundary) {
    const Vector v = direction_of(e);
    const Rational across = cross(left, v);
    if (sign(across) != 0) {
      const Rational on_edge = cross(e.source - start, left) / across;
      if (on_edge >= 0 && on_edge <= 1) meet(cross(e.source - start, v) / across);
    } else if (sign(cross(e.source - start, left)) == 0) {
      meet(dot(e.source - start, left) / dot(left, left));
      meet(dot(e.target - start, left) / dot(left, left));
    }
  }
  return start + step / 2 * left;
}

/// Gives every cell its verdict.
class Verdicts {
 public:
  Verdicts(const Region& p, const Region& q, const std::vector<Segment>& convolution)
      : p_(p), minus_q_(reflected(q)), convolution_(convolution) {}

  void decide(Arrangement& arrangement) const {
    for (auto face : arrangement.face_handles()) {
      const std::vector<Segment> around = boundary(face);
      if (around.empty()) continue;  // an empty sum: the whole plane is one face
      const Point x = point_inside(around);
      face->set_data(interiors_meet_at(x));
      require((winding_number(x, convolution_) > 0) == face->data(), x);
    }
    for (auto e : arrangement.edge_handles()) {
      const Segment s = segment(e);
      const Point x = midpoint(s.source, s.target);
      e->set_data(interiors_meet_at(x));
      e->twin()->set_data(e->data());
      // The sum of the open regions is open.
      require(!e->data() || (e->face()->data() && e->twin()->face()->data()), x);
    }
    for (auto v : arrangement.vertex_handles()) v->set_data(interiors_meet_at(point(v->point())));
  }

  bool interiors_meet_at(const Point& x) const {
    return interiors_meet(p_, translated(minus_q_, x));
  }

 private:
  static void require(bool agree, const Point& x) {
    if (!agree)
      throw VerdictsDiffer("the oracle's two verdicts differ at (" + x.x.get_str() + ", " +
                           x.y.get_str() + ")");
  }

  const Region& p_;
  Region minus_q_;
  const std::vector<Segment>& convolution_;
};

/// Whether all cells around a vertex are in the sum, though the vertex may not be.
bool surrounded(Arrangement::Vertex_handle v) {
  auto e = v->incident_halfedges();
  const auto first = e;
  do {
    if (!e->data() || !e->face()->data()) return false;
  } while (++e != first);
  return true;
}

/// The same for a point that need not be a vertex of the arrangement.
bool surrounded(const Point& x, const MinkowskiSum& closed, const std::vector<Segment>& dangling) {
  return locate(x, region_of(closed)) == Location::inside &&
         std::none_of(dangling.begin(), dangling.end(),
                      [&](const Segment& e) { return lies_on(x, e); });
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
  Arrangement arrangement = arrangement_of(convolution_segments);
  const Verdicts verdicts(p, q, convolution_segments);
  verdicts.decide(arrangement);

  BoundaryFeatures closed;
  BoundaryFeatures low_dimensional;
  for (auto e : arrangement.edge_handles()) {
    const bool left = e->face()->data();
    const bool right = e->twin()->face()->data();
    if (left != right) closed.edges.push_back(left ? segment(e) : reversed(segment(e)));
    if (left && right && !e->data()) low_dimensional.dangling_edges.push_back(segment(e));
  }
  for (auto v : arrangement.vertex_handles()) {
    if (!v->data() && surrounded(v)) low_dimensional.isolated_vertices.push_back(point(v->point()));
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
          {arrangement.number_of_faces(), arrangement.number_of_edges(),
           arrangement.number_of_vertices()}};
}

MinkowskiSum oracle_sum(const Region& p, const Region& q, Boundary boundary) {
  OracleSums sums = oracle_sums(p, q);
  return boundary == Boundary::closed ? sums.closed : sums.open;
}

}  // namespace oplus
