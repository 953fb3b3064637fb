// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <boost/functional/hash.hpp>
#include <unordered_map>
#include <utility>

#include "checked/arithmetic/leave_out_copies.hpp"
#include "checked/slide/edges_at_vertices.hpp"
#include "checked/slide/integer_summands.hpp"
#include "checked/slide/parallel_for.hpp"
#include "reference/definitions/convolution.hpp"

namespace oplus::slide {

/// The segments of the reduced convolution, by numbers.
template <typename Numbers>
class ReducedSegments {
 public:
  ReducedSegments(const Region& p, const Region& q, const Scaling& scaling, unsigned threads = 1)
      : summands_(p, q, scaling) {
    prepare(threads);
  }
  ReducedSegments(const KeptSummand<Numbers>& p, const KeptSummand<Numbers>& q,
                  const Scaling& scaling, unsigned threads = 1)
      : summands_(p, q, scaling) {
    prepare(threads);
  }

  const IntegerSummands<Numbers>& summands() const { return summands_; }
  /// Of summands that are kept for this sum only. Nothing is searched any more.
  void drop_boxes() { summands_.drop_boxes(); }
  std::size_t size() const { return segments_.size(); }

  const IntegerVector<Numbers>& direction(std::uint32_t segment) const {
    return edge_direction(segment).exact;
  }
  EdgeDirection<Numbers> edge_direction(std::uint32_t segment) const {
    const EdgeAtVertex& s = segments_[segment];
    return with_edge(s).direction(s.edge);
  }

  /// Where doubles show it, and there are so many that searching for copies costs little beside sliding along them:
  /// sums of many equal parts have few places.
  void leave_out_copies() {
    constexpr std::size_t few = 4096;
    if (!is_small<Numbers> || segments_.size() < few) return;
    using Direction = std::pair<double, double>;
    std::unordered_map<Direction, std::size_t, boost::hash<Direction>> edges_of;
    for (const auto* summand : {&summands_.p, &summands_.q})
      for (const NearSegment& edge : summand->near) ++edges_of[{edge.dx, edge.dy}];
    const auto edge = [&](const EdgeAtVertex& s) -> const NearSegment& {
      return with_edge(s).near[s.edge];
    };
    oplus::leave_out_copies(
        segments_,
        [&](const EdgeAtVertex& s) {
          return edges_of.find({edge(s).dx, edge(s).dy})->second > 1;
        },
        [&](const EdgeAtVertex& s) {
          const NearSegment &e = edge(s), &v = with_vertex(s).near[s.vertex];
          return std::array{e.x + v.x, e.y + v.y, e.dx, e.dy};
        });
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
  /// With the boxes, which are searched later, at the same time.
  void prepare(unsigned threads) {
    const auto add = [this] { segments_ = edges_at_vertices(summands_.p, summands_.q); };
    if (!summands_.pairs.is_empty()) return add();
    parallel_for(2, threads, [&](std::size_t step) {
      if (step == 0)
        summands_.prepare_boxes(threads);
      else
        add();
    });
  }

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
