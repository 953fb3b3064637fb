// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "checked/slide/blocked_interval.hpp"
#include "checked/slide/integer_summands.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// Finds segments, and parts of them, that are inside a + Q for a vertex a of P, where Q is convex, or the
/// other way round: these are inside the sum, the open one too. Where the edges of P are short beside Q, it
/// would take many pairs of edges to block them. What is inside may not be found: searches are short, and
/// rare after such that found nothing. One object a thread.
template <typename Numbers>
class ConvexCover {
 public:
  explicit ConvexCover(const IntegerSummands<Numbers>& summands) {
    if (summands.convex == Summand::Q) {
      convex_ = &summands.q, other_ = &summands.p, tree_ = &summands.tree_of_p;
    } else if (summands.convex == Summand::P) {
      convex_ = &summands.p, other_ = &summands.q, tree_ = &summands.tree_of_q;
    }
  }

  bool contained_the_last() const { return contained_the_last_; }

  /// Whether all of a segment, its ends too, is found to be inside.
  bool contains(const ReducedSegment<Numbers>& segment) {
    if (!convex_) return false;
    contained_the_last_ = find(of_all_, segment.near, {0, 1},
                               [&](std::uint32_t vertex) { return contains_at(vertex, segment); });
    return contained_the_last_;
  }

  /// An interval in which t is and all of which is inside, if one is found.
  std::optional<BlockedInterval<Numbers>> interval_at(const ReducedSegment<Numbers>& segment,
                                                      const Fraction<Numbers>& t) {
    std::optional<BlockedInterval<Numbers>> interval;
    if (convex_)
      find(of_parts_, segment.near, {t.near(), t.near()}, [&](std::uint32_t vertex) {
        interval = interval_at(vertex, segment, t);
        return interval.has_value();
      });
    return interval;
  }

 private:
  using Vector = IntegerVector<Numbers>;
  using Value = typename Numbers::Value;

  bool contains_at(std::uint32_t vertex, const ReducedSegment<Numbers>& segment) const {
    const NearSegment& s = segment.near;
    if (is_certainly_outside(vertex, {s.x, s.y, segment.error}) ||
        is_certainly_outside(vertex, {s.x + s.dx, s.y + s.dy, segment.error}))
      return false;
    const Vector from = segment.exact.source - other_->edges[vertex].source;
    const Vector to = from + segment.exact.direction;
    return std::all_of(convex_->edges.begin(), convex_->edges.end(), [&](const auto& edge) {
      return is_inside(cross(edge.direction, from - edge.source)) &&
             is_inside(cross(edge.direction, to - edge.source));
    });
  }

  /// Given a skew product with an edge: whether the place is on the inner side.
  static bool is_inside(const Value& side) {
    return OPLUS_MUTANT("slide-covers-with-closed-summands",
                        "segments on the boundary of a convex summand, moved, count as inside it")
               ? side >= 0
               : side > 0;
  }

  /// Whether doubles tell that a place is outside.
  bool is_certainly_outside(std::uint32_t vertex, const ApproximatePoint& place) const {
    const ApproximatePoint at = difference(place, other_->near[vertex]);
    return std::any_of(convex_->near.begin(), convex_->near.end(), [&](const NearSegment& edge) {
      const ApproximatePoint d = difference(at, edge);
      const double left = edge.dx * d.y, right = edge.dy * d.x;
      return right - left > 0x1p-48 * (std::abs(left) + std::abs(right)) +
                                2 * d.error * (std::abs(edge.dx) + std::abs(edge.dy));
    });
  }

  std::optional<BlockedInterval<Numbers>> interval_at(std::uint32_t vertex,
                                                      const ReducedSegment<Numbers>& segment,
                                                      const Fraction<Numbers>& t) const {
    if (is_certainly_outside(vertex, near_place(segment, t))) return std::nullopt;
    const Vector from = segment.exact.source - other_->edges[vertex].source;
    std::optional<Fraction<Numbers>> first, last;
    for (const IntegerSegment<Numbers>& edge : convex_->edges) {
      const Value side = cross(edge.direction, from - edge.source);
      const Value slope = cross(edge.direction, segment.exact.direction);
      if (slope == 0) {
        if (!is_inside(side)) return std::nullopt;
        continue;
      }
      Fraction<Numbers> end = slope > 0 ? Fraction<Numbers>(Value(-side), slope)
                                        : Fraction<Numbers>(side, Value(-slope));
      if (!(slope > 0 ? end < t : t < end)) return std::nullopt;
      std::optional<Fraction<Numbers>>& so_far = slope > 0 ? first : last;
      if (!so_far || (slope > 0 ? *so_far < end : end < *so_far)) so_far = std::move(end);
    }
    return BlockedInterval<Numbers>{*first, *last};
  }

  struct Searches {
    std::uint32_t vertex = 0;  ///< of the last that found one
    int patience = 4;
    int left_out = 0;
  };
  struct Range {
    double from, to;
  };

  /// Looks for a vertex that is accepted: the last one, its neighbours, then those in boxes.
  template <typename Accept>
  bool find(Searches& searches, const NearSegment& segment, const Range& range,
            const Accept& accept) {
    constexpr int most_patience = 16;
    const auto is_found = [&](std::uint32_t vertex) {
      if (!accept(vertex)) return false;
      searches.vertex = vertex;
      return true;
    };
    const std::uint32_t last = searches.vertex;
    const std::uint32_t next = last + 1 == other_->edges.size() ? 0 : last + 1;
    const bool is_rare = searches.patience == 0 && ++searches.left_out % most_patience != 0;
    const bool found = is_found(last) || is_found(next) || is_found(other_->previous[last]) ||
                       (!is_rare && find_in_boxes(segment, range, is_found));
    searches.patience = std::clamp(searches.patience + (found ? 2 : -1), 0, most_patience);
    return found;
  }

  /// Looks into boxes that can have a vertex a such that the range is inside a + Q, by doubles, which may
  /// err.
  template <typename IsFound>
  bool find_in_boxes(const NearSegment& s, const Range& range, const IsFound& is_found) {
    constexpr int most_nodes = 256;
    limits_.clear();  // of [d, a] for the direction d of each edge
    for (const NearSegment& e : convex_->near) {
      const double slope = e.dx * s.dy - e.dy * s.dx;
      limits_.push_back(e.dx * (s.y - e.y) - e.dy * (s.x - e.x) +
                        std::min(range.from * slope, range.to * slope));
    }
    std::size_t waiting = 0;
    waiting_[waiting++] = 0;
    for (int nodes = 0; waiting > 0 && nodes < most_nodes; ++nodes) {
      const std::uint32_t number = waiting_[--waiting];
      const FloatBoxTree::Node& node = (*tree_)[number];
      if (is_beside(node.box)) continue;
      if (node.is_leaf()) {
        if (is_found(node.edge)) return true;
      } else if (waiting + 2 <= waiting_.size()) {
        waiting_[waiting++] = node.right;
        waiting_[waiting++] = number + 1;
      }
    }
    return false;
  }

  bool is_beside(const FloatBox& box) const {
    const double low_x = box[0], low_y = box[1], high_x = -box[2], high_y = -box[3];
    for (std::size_t j = 0; j < limits_.size(); ++j) {
      const NearSegment& e = convex_->near[j];
      if (e.dx * (e.dx > 0 ? low_y : high_y) - e.dy * (e.dy > 0 ? high_x : low_x) >= limits_[j])
        return true;
    }
    return false;
  }

  const IntegerSummand<Numbers>* convex_ = nullptr;
  const IntegerSummand<Numbers>* other_ = nullptr;
  const FloatBoxTree* tree_ = nullptr;
  Searches of_all_;
  Searches of_parts_;
  bool contained_the_last_ = false;
  std::vector<double> limits_;
  std::array<std::uint32_t, 64> waiting_;
};

}  // namespace oplus::slide
