// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/cells.hpp"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mpq_class.h>

#include <set>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/ray.hpp"

namespace oplus {

namespace {

// Plain rationals: no filter, no lazy evaluation. Vertices and faces carry their numbers.
using Traits = CGAL::Arr_segment_traits_2<CGAL::Simple_cartesian<Rational>>;
using Dcel = CGAL::Arr_extended_dcel<Traits, std::size_t, bool, std::size_t>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;

Point point(const Traits::Point_2& p) { return {p.x(), p.y()}; }

template <typename Halfedge>
Segment segment(Halfedge e) {
  return {point(e->source()->point()), point(e->target()->point())};
}

/// The pieces meet in common ends only, so that CGAL has but to connect them: its sweep, in 5.5,
/// fails on some overlaps (docs/findings.md).
Arrangement arrangement_of(const std::vector<std::vector<Segment>>& of_segments) {
  std::set<Segment> pieces;
  for (const std::vector<Segment>& of_segment : of_segments) {
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

}  // namespace

Cells cells(const std::vector<Segment>& segments) {
  return cells_of_pieces(cut_at_intersections(segments));
}

Cells cells_of_pieces(const std::vector<std::vector<Segment>>& pieces) {
  Arrangement arrangement = arrangement_of(pieces);
  Cells result;
  for (auto face : arrangement.face_handles()) {
    face->set_data(result.faces.size());
    if (face->is_unbounded()) result.unbounded_face = face->data();
    result.faces.push_back(boundary(face));
  }
  for (auto vertex : arrangement.vertex_handles()) {
    vertex->set_data(result.vertices.size());
    result.vertices.push_back(point(vertex->point()));
  }
  for (auto edge : arrangement.edge_handles()) {
    const Segment s = segment(edge);
    const auto e = s.source < s.target ? edge : edge->twin();
    result.edges.push_back({segment(e), e->face()->data(), e->twin()->face()->data(),
                            e->source()->data(), e->target()->data()});
  }
  return result;
}

Point point_inside(const std::vector<Segment>& boundary) {
  const Vector along = direction_of(boundary[0]);
  return point_beside(midpoint(boundary[0].source, boundary[0].target), {-along.y, along.x},
                      boundary);
}

}  // namespace oplus
