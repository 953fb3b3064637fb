// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "checked/slide/edges_at_vertices.hpp"
#include "checked/slide/integer_summands.hpp"
#include "reference/definitions/convolution.hpp"

namespace oplus::slide {

/// The segments of the reduced convolution, by numbers.
template <typename Numbers>
class ReducedSegments {
 public:
  ReducedSegments(const Region& p, const Region& q, const Scaling& scaling)
      : summands_(p, q, scaling), segments_(edges_at_vertices(summands_.p, summands_.q)) {}
  ReducedSegments(const KeptSummand<Numbers>& p, const KeptSummand<Numbers>& q,
                  const Scaling& scaling)
      : summands_(p, q, scaling), segments_(edges_at_vertices(summands_.p, summands_.q)) {}

  const IntegerSummands<Numbers>& summands() const { return summands_; }
  void prepare_boxes() { summands_.prepare_boxes(); }
  std::size_t size() const { return segments_.size(); }

  const IntegerVector<Numbers>& direction(std::uint32_t segment) const {
    return edge_direction(segment).exact;
  }
  EdgeDirection<Numbers> edge_direction(std::uint32_t segment) const {
    const EdgeAtVertex& s = segments_[segment];
    return with_edge(s).direction(s.edge);
  }

  IntegerSegment<Numbers> exact(std::uint32_t segment) const {
    const EdgeAtVertex& s = segments_[segment];
    const IntegerSegment<Numbers>& edge = with_edge(s).edges[s.edge];
    return {edge.source + with_vertex(s).edges[s.vertex].source, edge.direction};
  }

  ReducedSegment<Numbers> operator[](std::uint32_t segment) const {
    const EdgeAtVertex& s = segments_[segment];
    const NearSegment& e = with_edge(s).near[s.edge];
    const NearSegment& v = with_vertex(s).near[s.vertex];
    const std::uint32_t entering = with_vertex(s).previous[s.vertex];
    const bool of_p = s.edge_of == Summand::P;
    return {exact(segment),
            {e.x + v.x, e.y + v.y, e.dx, e.dy},
            error_of_places(e, v),
            {of_p ? EdgePair{s.edge, entering} : EdgePair{entering, s.edge},
             of_p ? EdgePair{s.edge, s.vertex} : EdgePair{s.vertex, s.edge}}};
  }

  Origin origin(std::uint32_t segment) const {
    const EdgeAtVertex& s = segments_[segment];
    return {s.edge_of, with_edge(s).name(s.edge), with_vertex(s).name(s.vertex)};
  }

 private:
  const IntegerSummand<Numbers>& with_edge(const EdgeAtVertex& s) const {
    return s.edge_of == Summand::P ? summands_.p : summands_.q;
  }
  const IntegerSummand<Numbers>& with_vertex(const EdgeAtVertex& s) const {
    return s.edge_of == Summand::P ? summands_.q : summands_.p;
  }

  IntegerSummands<Numbers> summands_;
  ShortList<EdgeAtVertex> segments_;
};

}  // namespace oplus::slide
