// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "checked/slide/integer_summands.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// Finds segments that are inside a + Q for a vertex a of P, where Q is convex, or the other way round:
/// all of such a segment is inside the sum, the open one too. Where the edges of P are short beside Q, it
/// would take many pairs of edges to block it. One object a thread.
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

  /// Whether it is found that all of the track, its ends too, is inside. It may be without being found:
  /// the search is short, and shorter where it found nothing lately.
  bool contains(const Track<Numbers>& track) {
    if (!convex_) return false;
    constexpr int most_patience = 16;
    const bool is_tired = patience_ <= 0 && ++waited_ % most_patience != 0;
    const auto size = static_cast<std::uint32_t>(other_->edges.size());
    bool is_inside = contains_at(recent_, track);
    for (const std::uint32_t next : {recent_ + 1, other_->previous[recent_]}) {
      if (is_inside) break;
      is_inside = contains_at(next == size ? 0 : next, track);
    }
    if (!is_inside && !is_tired) is_inside = search(track);
    contained_the_last_ = is_inside;
    patience_ = std::clamp(patience_ + (is_inside ? 2 : -1), 0, most_patience);
    return is_inside;
  }

 private:
  using Vector = IntegerVector<Numbers>;

  bool contains_at(std::uint32_t vertex, const Track<Numbers>& track) {
    const Vector from = track.exact.source - other_->edges[vertex].source;
    const Vector to = from + track.exact.direction;
    for (const IntegerSegment<Numbers>& edge : convex_->edges) {
      const int side = std::min(sign_of(cross(edge.direction, from - edge.source)),
                                sign_of(cross(edge.direction, to - edge.source)));
      const bool is_beside =
          OPLUS_MUTANT("slide-covers-with-closed-summands",
                       "segments on the boundary of a convex summand, moved, count as inside it")
              ? side < 0
              : side <= 0;
      if (is_beside) return false;
    }
    recent_ = vertex;
    return true;
  }

  /// Looks for a vertex in the boxes in which one can be, by doubles: contains_at() decides.
  bool search(const Track<Numbers>& track) {
    constexpr int most_nodes = 48;
    const NearSegment& s = track.near;
    // [d, a] is less than these for the direction d of each edge.
    limits_.clear();
    for (const NearSegment& e : convex_->near) {
      const double x = s.x - e.x, y = s.y - e.y;
      limits_.push_back(e.dx * y - e.dy * x + std::min(0.0, e.dx * s.dy - e.dy * s.dx));
    }
    std::size_t waiting = 0;
    waiting_[waiting++] = 0;
    for (int nodes = 0; waiting > 0 && nodes < most_nodes; ++nodes) {
      const std::uint32_t number = waiting_[--waiting];
      const BoxTree::Node& node = (*tree_)[number];
      if (is_beside(node.box)) continue;
      if (node.is_leaf()) {
        if (contains_at(node.edge, track)) return true;
      } else if (waiting + 2 <= waiting_.size()) {
        waiting_[waiting++] = node.right;
        waiting_[waiting++] = number + 1;
      }
    }
    return false;
  }

  bool is_beside(const Box& box) const {
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
  const BoxTree* tree_ = nullptr;
  std::uint32_t recent_ = 0;  ///< the last vertex at which a segment was covered
  bool contained_the_last_ = false;
  int patience_ = 4;
  int waited_ = 0;
  std::vector<double> limits_;
  std::array<std::uint32_t, 64> waiting_;
};

}  // namespace oplus::slide
