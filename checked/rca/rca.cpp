// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/rca/rca.hpp"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "checked/arrangement/non_crossing_traits.hpp"
#include "checked/arrangement/strands.hpp"
#include "checked/collision/hierarchy_collision.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = NonCrossingTraits<Kernel>;
/// A face carries whether it belongs to the complement of the sum.
using Cells = CGAL::Arr_face_extended_dcel<Traits, bool>;
using Arrangement = CGAL::Arrangement_2<Traits, Cells>;
using Vertex = Arrangement::Vertex_handle;
using Halfedge = Arrangement::Halfedge_handle;
using Face = Arrangement::Face_handle;

static_assert(std::is_same_v<Kernel::FT::ET, Rational>, "CGAL is compiled with CGAL_USE_GMPXX");

Kernel::FT number(const Rational& value) { return value; }
Rational number(const Kernel::FT& value) { return CGAL::exact(value); }
Point point(Vertex v) { return {number(v->point().x()), number(v->point().y())}; }
Segment segment(Halfedge e) { return {point(e->source()), point(e->target())}; }
Point middle(Halfedge e) { return midpoint(point(e->source()), point(e->target())); }

/// The arrangement of the reduced convolution, and what is decided on it.
class Rca {
 public:
  Rca(const Region& p, const Region& q)
      : p_(p),
        q_(q),
        reduced_(reduced_convolution(p, q)),
        strands_(strands(segments(reduced_))),
        collision_(hierarchy_collision(p, q)) {
    const std::vector<Traits::X_monotone_curve_2> with_labels = curves();
    CGAL::insert(arrangement_, with_labels.begin(), with_labels.end());
    statistics_.segments = reduced_.size();
    statistics_.arrangement_vertices = arrangement_.number_of_vertices();
    statistics_.arrangement_edges = arrangement_.number_of_edges();
    statistics_.arrangement_faces = arrangement_.number_of_faces();
  }

  RcaResult run(Boundary boundary, WithOrigins with_origins) {
    for (Face face : arrangement_.face_handles()) {
      face->set_data(is_in_complement(face));
      if (face->data()) add_boundary_of(face, with_origins);
    }
    if (boundary == Boundary::open) find_low_dimensional_features(with_origins);
    MinkowskiSum sum = canonical_sum(features_);
    Origins origins = with_origins == WithOrigins::yes ? origins_along(edges(sum)) : Origins{};
    return {std::move(sum), std::move(origins), statistics_};
  }

 private:
  /// A curve a strand. A segment's edge belongs to a chain, translated by the segment's vertex; a
  /// strand of several segments belongs to no chain.
  std::vector<Traits::X_monotone_curve_2> curves() const {
    std::map<std::tuple<Summand, std::size_t, VertexIndex>, TranslatedChain> names;
    const auto chain_of = [&](const Strand& strand) {
      if (strand.along.size() + strand.against.size() > 1) return no_chain;
      const Origin& origin =
          reduced_[strand.along.empty() ? strand.against[0] : strand.along[0]].origin;
      const auto next_name = static_cast<TranslatedChain>(names.size() + 1);
      return names.try_emplace({origin.edge_of, origin.edge.chain, origin.vertex}, next_name)
          .first->second;
    };
    std::vector<Traits::X_monotone_curve_2> result;
    result.reserve(strands_.size());
    for (std::uint32_t i = 0; i < strands_.size(); ++i) {
      const auto& [source, target] = strands_[i].segment;
      result.emplace_back(CGAL::Arr_segment_2<Kernel>({number(source.x), number(source.y)},
                                                      {number(target.x), number(target.y)}),
                          chain_of(strands_[i]), i);
    }
    return result;
  }

  /// Calls `action(segment, runs_along)` for each convolution segment that an edge is a part of;
  /// runs_along: in the halfedge's direction, not against it.
  template <typename Action>
  void for_each_origin(Halfedge e, Action action) {
    const bool to_the_right = e->direction() == CGAL::ARR_LEFT_TO_RIGHT;
    const Strand& strand = strands_[e->curve().strand()];
    for (const std::uint32_t i : strand.along) action(reduced_[i], to_the_right);
    for (const std::uint32_t i : strand.against) action(reduced_[i], !to_the_right);
  }

  /// Whether all convolution segments of this edge have its face to their right.
  bool only_runs_against(Halfedge e) {
    bool against = true;
    for_each_origin(e, [&](const ConvolutionSegment&, bool along) { against = against && !along; });
    return against;
  }

  /// Whether `holds` for all halfedges around a face, the face to their left.
  template <typename Holds>
  static bool all_around(Face face, Holds holds) {
    const auto along = [&](Arrangement::Ccb_halfedge_circulator first) {
      auto e = first;
      do {
        if (!holds(e)) return false;
      } while (++e != first);
      return true;
    };
    return std::all_of(face->outer_ccbs_begin(), face->outer_ccbs_end(), along) &&
           std::all_of(face->inner_ccbs_begin(), face->inner_ccbs_end(), along);
  }

  /// Left of a segment is the sum (thesis, Observation 2.2.4), so a face of the complement is to
  /// the right of all segments around it. This is the filter for orientable loops (Lemma 3.1.2) on
  /// faces instead of loops (Section 3.2.3); antennas fail it, too.
  bool may_be_in_complement(Face face) {
    return all_around(face, [&](Halfedge e) { return only_runs_against(e); });
  }

  /// Around a face of the complement, the sum is on the other side of each edge.
  void add_boundary_of(Face face, WithOrigins with_origins) {
    all_around(face, [&](Halfedge e) {
      features_.edges.push_back(segment(e->twin()));
      if (with_origins == WithOrigins::yes) remember_origins(e->twin(), features_.edges.back());
      return true;
    });
  }

  bool is_in_complement(Face face) {
    if (face->is_unbounded()) return true;
    if (!may_be_in_complement(face)) return false;
    ++statistics_.candidate_faces;
    // An edge all of whose segments run in one direction is not dangling (Theorem 3.2.8), so it is
    // in the open sum iff the face is.
    return OPLUS_MUTANT("candidates-need-no-hole-test") ||
           !interiors_meet_at(middle(*face->outer_ccbs_begin()));
  }

  bool interiors_meet_at(const Point& x) {
    ++statistics_.hole_tests;
    return collision_->interiors_meet_at(x);
  }

  /// Section 3.2.4: the filters of Theorems 3.2.8 and 3.2.10, then a collision test.
  void find_low_dimensional_features(WithOrigins with_origins) {
    std::set<Vertex> on_features;
    for (Halfedge e : arrangement_.edge_handles()) {
      if (e->face()->data() || e->twin()->face()->data()) {
        on_features.insert({e->source(), e->target()});
        continue;
      }
      bool along_one = false;
      bool against_one = false;
      for_each_origin(e, [&](const ConvolutionSegment&, bool along) {
        (along ? along_one : against_one) = true;
      });
      if (!along_one || !against_one || interiors_meet_at(middle(e))) continue;
      on_features.insert({e->source(), e->target()});
      Segment dangling = segment(e);
      if (dangling.target < dangling.source) dangling = reversed(dangling);
      if (with_origins == WithOrigins::yes) remember_origins(e, dangling);
      features_.dangling_edges.push_back(std::move(dangling));
    }
    for (Vertex v : arrangement_.vertex_handles()) {
      if (on_features.contains(v) || !has_three_directions(v)) continue;
      const Point x = point(v);
      if (!interiors_meet_at(x)) features_.isolated_vertices.push_back(x);
    }
    find_isolated_vertices_at_touching_points();
  }

  /// Where touching points of both summands meet, a vertex may be isolated without a segment of the
  /// reduced convolution through it (docs/findings.md, on Theorem 2.3.2).
  void find_isolated_vertices_at_touching_points() {
    const std::vector<Point> of_p = touching_points(p_);
    const std::vector<Point> of_q = of_p.empty() ? of_p : touching_points(q_);
    if (of_q.empty() || OPLUS_MUTANT("touching-points-are-not-tested")) return;
    const Region closed = region_of(canonical_sum({features_.edges, {}, {}}));
    for (const Point& p : of_p) {
      for (const Point& q : of_q) {
        const Point x = p + q;
        const bool on_dangling_edge =
            std::any_of(features_.dangling_edges.begin(), features_.dangling_edges.end(),
                        [&](const Segment& e) { return lies_on(x, e); });
        if (!on_dangling_edge && locate(x, closed) == Location::inside && !interiors_meet_at(x))
          features_.isolated_vertices.push_back(x);
      }
    }
  }

  bool has_three_directions(Vertex v) {
    std::vector<Vector> directions;
    auto e = v->incident_halfedges();
    const auto first = e;
    do {
      for_each_origin(e, [&](const ConvolutionSegment& s, bool) {
        const Vector d = direction_of(s.segment);
        if (std::none_of(directions.begin(), directions.end(),
                         [&](const Vector& known) { return same_direction(known, d); }))
          directions.push_back(d);
      });
    } while (++e != first && directions.size() < 3);
    return directions.size() >= 3;
  }

  /// On the regularized boundary all origins run along the edge; on a dangling edge, either way.
  void remember_origins(Halfedge e, const Segment& edge) {
    Piece piece{edge, {}};
    for_each_origin(e,
                    [&](const ConvolutionSegment& s, bool) { piece.origins.push_back(s.origin); });
    pieces_.emplace(edge.source, std::move(piece));
  }

  /// Collects the origins of the pieces that each maximal edge consists of.
  Origins origins_along(const std::vector<Segment>& of_sum) const {
    Origins result;
    for (const Segment& edge : of_sum) {
      std::set<Origin> origins;
      for (Point at = edge.source; at != edge.target;) {
        const auto [begin, end] = pieces_.equal_range(at);
        const auto piece = std::find_if(begin, end, [&](const auto& candidate) {
          return same_direction(direction_of(candidate.second.edge), direction_of(edge));
        });
        OPLUS_ENSURES(piece != end, "Theorem 2.3.2");
        origins.insert(piece->second.origins.begin(), piece->second.origins.end());
        at = piece->second.edge.target;
      }
      result.emplace_back(origins.begin(), origins.end());
    }
    return result;
  }

  /// An edge of the arrangement on the sum's boundary.
  struct Piece {
    Segment edge;
    std::vector<Origin> origins;
  };

  const Region& p_;
  const Region& q_;
  std::vector<ConvolutionSegment> reduced_;
  std::vector<Strand> strands_;
  std::unique_ptr<CollisionTest> collision_;
  Arrangement arrangement_;
  RcaStatistics statistics_;
  BoundaryFeatures features_;
  std::multimap<Point, Piece> pieces_;  ///< by their sources
};

}  // namespace

RcaResult rca(const Region& p, const Region& q, Boundary boundary, WithOrigins with_origins) {
  return Rca(p, q).run(boundary, with_origins);
}

}  // namespace oplus
