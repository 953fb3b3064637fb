// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "checked/slide/blocked_interval.hpp"
#include "checked/slide/integer_summands.hpp"
#include "checked/slide/places_by_digits.hpp"
#include "checked/slide/short_list.hpp"
#include "checked/slide/strip.hpp"
#include "checked/slide/swept_box.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// How much a search had to do.
struct SearchEffort {
  std::size_t covered = 0;  ///< segments inside a convex summand, moved to a vertex
  std::size_t probes = 0;
  std::size_t box_pairs = 0;    ///< pairs of boxes opened or found to be edges
  std::size_t by_doubles = 0;   ///< pairs of edges that doubles told not to block
  std::size_t by_integers = 0;  ///< pairs of edges that took integers

  SearchEffort& operator+=(const SearchEffort& more) {
    covered += more.covered;
    probes += more.probes;
    box_pairs += more.box_pairs;
    by_doubles += more.by_doubles;
    by_integers += more.by_integers;
    return *this;
  }
};

/// Looks for pairs of edges that block places on a segment. It remembers which blocked lately, since
/// the next segment is near.
template <typename Numbers>
class BlockingSearch {
 public:
  using Interval = BlockedInterval<Numbers>;

  BlockingSearch(const IntegerSummands<Numbers>& summands, Shift shift)
      : summands_(summands), shift_(shift), digits_(summands) {
    if (!compares_all_pairs()) summands.prepare_boxes();
  }

  /// An interval that contains t, if there is one.
  std::optional<Interval> at(const ReducedSegment<Numbers>& segment, const Fraction<Numbers>& t) {
    ++effort.probes;
    const ApproximatePoint near = near_place(segment, t);
    digits_.look_at(segment, t, t);
    for (std::size_t k = 0; k < remembered_; ++k) {
      if (auto found = containing(segment, t, near, recent_[k])) {
        std::rotate(recent_.begin(), recent_.begin() + static_cast<std::ptrdiff_t>(k),
                    recent_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        return found;
      }
    }
    if (compares_all_pairs()) {
      std::optional<Interval> found;
      each_near_pair(segment, [&](const EdgePair& pair) {
        if (found) return;
        found = containing(segment, t, near, pair);
        if (found) remember(pair);
      });
      return found;
    }
    // What a probe leaves out, each_pair() looks into.
    const bool shifts = shift_ == Shift::to_the_right && summands_.margins.area_is_exact;
    const FloatBox point = (shifts ? shifted_to_the_right(segment, near) : near).box();
    strips_from_ = effort.box_pairs + without_strips;
    left_out_.clear();
    std::size_t waiting = 0;
    Pair boxes{0, 0};
    if (!contains(sum_of(boxes), point)) {
      left_out_.push_back(boxes);
      return std::nullopt;
    }
    while (true) {
      ++effort.box_pairs;
      if (const auto halves = halves_of(boxes)) {
        const FloatBox first = sum_of(halves->first), second = sum_of(halves->second);
        const bool in_first = contains(first, point) && !are_apart(halves->first, near, near);
        const bool in_second = contains(second, point) && !are_apart(halves->second, near, near);
        if (in_first && in_second) {
          const bool swap = distance(second, near) < distance(first, near);
          waiting_[waiting++] = swap ? halves->first : halves->second;
          boxes = swap ? halves->second : halves->first;
          continue;
        }
        if (!in_first) left_out_.push_back(halves->first);
        if (!in_second && !OPLUS_MUTANT("slide-leaves-boxes-out",
                                        "some boxes that a probe leaves out are never looked into"))
          left_out_.push_back(halves->second);
        if (in_first || in_second) {
          boxes = in_first ? halves->first : halves->second;
          continue;
        }
      } else {
        const EdgePair pair = edges_in(boxes);
        if (auto found = containing(segment, t, near, pair)) {
          remember(pair);
          return found;
        }
        left_out_.push_back(boxes);
      }
      if (waiting == 0) return std::nullopt;
      boxes = waiting_[--waiting];
    }
  }

  /// Of the last interval that at() found.
  const EdgePair& last_pair() const { return recent_[0]; }
  /// Whether each_pair() needs no probe before it.
  bool compares_all_pairs() const { return !summands_.pairs.is_empty(); }

  /// Prepares each_pair() without a probe.
  void leave_out_all() { left_out_.assign(1, {0, 0}); }

  /// Visits all pairs of edges that can block a place inside a piece of the segment, by the numbers of the
  /// edges; without a shift, all those that can touch each other at a place on it.
  /// Requires: at() was asked about a place on this piece last, and found none; or leave_out_all().
  template <typename Visit>
  void each_pair(const ReducedSegment<Numbers>& segment, const Piece<Numbers>& piece,
                 const Visit& visit) {
    if (compares_all_pairs()) return each_near_pair(segment, visit);
    const ApproximatePoint from = near_place(segment, piece.from),
                           to = near_place(segment, piece.to);
    digits_.look_at(segment, piece.from, piece.to);
    const bool exactly = shift_ == Shift::to_the_right && summands_.margins.area_is_exact &&
                         piece.from.denominator() == 1 && piece.to.denominator() == 1;
    const auto visit_if_near = [&](const EdgePair& pair) {
      if (comes_apart(segment, pair)) return;
      if (exactly ? outside_exactly(pair, from, to)
                  : certainly_outside(pair, from, to) || meets_end_only(segment, pair) ||
                        outside_closely(segment, pair, piece.from, piece.to))
        return;
      visit(pair);
    };
    SweptBox swept(from, to);
    if (shift_ == Shift::to_the_right && summands_.margins.area_is_exact)
      swept.leave_out_touching(segment.near, exactly);
    strips_from_ = effort.box_pairs + without_strips;
    const auto may_meet = [&](const Pair& boxes) {
      return swept.may_meet(sum_of(boxes)) && !are_apart(boxes, from, to);
    };
    for (Pair boxes : left_out_) {
      if (!may_meet(boxes)) continue;
      std::size_t waiting = 0;
      while (true) {
        ++effort.box_pairs;
        if (const auto halves = halves_of(boxes)) {
          const bool first = may_meet(halves->first), second = may_meet(halves->second);
          if (first && second) waiting_[waiting++] = halves->second;
          if (first || second) {
            boxes = first ? halves->first : halves->second;
            continue;
          }
        } else {
          visit_if_near(edges_in(boxes));
        }
        if (waiting == 0) break;
        boxes = waiting_[--waiting];
      }
    }
  }

  std::optional<Interval> interval_of(const ReducedSegment<Numbers>& segment,
                                      const EdgePair& pair) {
    ++effort.by_integers;
    return blocked_interval(segment.exact, summands_.p.edges[pair.first],
                            summands_.q.edges[pair.second], shift_);
  }

  SearchEffort effort;

 private:
  /// Visits all pairs of edges that can block a place on the segment.
  template <typename Visit>
  void each_near_pair(const ReducedSegment<Numbers>& segment, const Visit& visit) {
    const Margins& margins = summands_.margins;
    const double margin = margins.area_is_exact ? 0 : 4 * margins.area;
    // Where doubles are exact, a segment beside a strip may touch its side; along it, the shift decides.
    const double touching = OPLUS_MUTANT("slide-passes-sides-by") ? margin : std::max(margin, 0.5);
    effort.by_doubles += summands_.p.near.size() * summands_.q.near.size();
    digits_.look_at(segment, {0, 1}, {1, 1});
    summands_.pairs.each_near(
        segment.near, {shift_ == Shift::none ? touching : margin, touching},
        [&](const EdgePair& pair) {
          --effort.by_doubles;
          if (comes_apart(segment, pair)) return;
          if (digits_.are_needed() && (meets_end_only(segment, pair) || outside_by_digits(pair)))
            return;
          visit(pair);
        });
  }

  using Pair = std::pair<std::uint32_t, std::uint32_t>;  ///< of nodes

  /// Whether these are edges that touch each other all along the segment, and that the shift moves apart;
  /// without it they count, since their contact begins and ends.
  bool comes_apart(const ReducedSegment<Numbers>& segment, const EdgePair& pair) const {
    // Without jumps that cannot be predicted.
    const auto is = [&](const EdgePair& other) {
      return int{((pair.first ^ other.first) | (pair.second ^ other.second)) == 0};
    };
    return shift_ == Shift::to_the_right && (is(segment.contact[0]) | is(segment.contact[1])) != 0;
  }

  /// Whether doubles tell that a segment, which has an end at a corner of the sum of a pair of edges, leads
  /// away from there: most pairs that share a vertex with those that touch.
  bool meets_end_only(const ReducedSegment<Numbers>& segment, const EdgePair& pair) {
    if (shift_ == Shift::none || summands_.margins.area_is_exact) return false;
    const bool edge_of_p = segment.edge_is_of_p();
    const auto of = [&](const EdgePair& both, bool p) { return p ? both.first : both.second; };
    const std::uint32_t vertex = of(segment.contact[1], !edge_of_p);
    const std::uint32_t at_vertex = of(pair, !edge_of_p);
    if (at_vertex != vertex && at_vertex != of(segment.contact[0], !edge_of_p)) return false;
    const auto& previous = (edge_of_p ? summands_.p : summands_.q).previous;
    const std::uint32_t edge = of(segment.contact[0], edge_of_p), beside = of(pair, edge_of_p);
    const bool before = previous[edge] == beside;
    if (!before && previous[beside] != edge) return false;
    // The sides of the parallelogram lead away from the corner, and so does the segment.
    const auto u = (edge_of_p ? summands_.p : summands_.q).direction(beside);
    const auto w = (edge_of_p ? summands_.q : summands_.p).direction(at_vertex);
    const EdgeDirection<Numbers> d{segment.exact.direction, segment.near};
    const int turn = certain_turn(u, w);
    const int sign_u = before ? -1 : 1, sign_w = at_vertex == vertex ? 1 : -1;
    const int from_u = certain_turn(u, d);
    const int to_w = certain_turn(d, w);
    const int sign_d = before ? 1 : -1;
    const int inside = turn * sign_u * sign_w;
    if (inside * from_u * sign_u * sign_d >= 0 && inside * to_w * sign_d * sign_w >= 0)
      return false;
    ++effort.by_doubles;
    return true;
  }

  /// Whether no place between two is in the sum of a pair of edges, a parallelogram, or its boundary,
  /// given points near the two.
  bool certainly_outside(const EdgePair& pair, const ApproximatePoint& from,
                         const ApproximatePoint& to) {
    return beside(pair, from, to, summands_.margins.area,
                  [](double low, double high, double a, double b, double /*right*/) {
                    return std::max(a, b) < low || std::min(a, b) > high;
                  });
  }

  /// Whether no place between two ends of segments, shifted, is inside the sum of a pair of edges.
  bool outside_exactly(const EdgePair& pair, const ApproximatePoint& from,
                       const ApproximatePoint& to) {
    return beside(pair, from, to, 0, [](double low, double high, double a, double b, double right) {
      // Along a side, the shift decides.
      const bool is_along =
          a == b && (a == low ? right > 0 : a == high && right < 0) && low < high &&
          !OPLUS_MUTANT("slide-passes-sides-by",
                        "doubles leave out parallelograms along whose sides a segment runs");
      return !is_along && (std::max(a, b) <= low || std::min(a, b) >= high);
    });
  }

  /// Whether the part of a line between two points is beside one of the two strips of which the sum of a
  /// pair of edges is the intersection; beside_strip() is told across which part of the line is, and
  /// whether a shift to the right moves it that way.
  template <typename BesideStrip>
  bool beside(const EdgePair& pair, const ApproximatePoint& from, const ApproximatePoint& to,
              double margin, const BesideStrip& beside_strip) {
    const NearSegment& e = summands_.p.near[pair.first];
    const NearSegment& f = summands_.q.near[pair.second];
    const double area = e.dx * f.dy - e.dy * f.dx;
    const double low = std::min(area, 0.0) - margin, high = std::max(area, 0.0) + margin;
    const double corner_x = e.x + f.x, corner_y = e.y + f.y;
    const auto along_e = [&](const ApproximatePoint& c) {
      return (c.x - corner_x) * f.dy - (c.y - corner_y) * f.dx;
    };
    const auto along_f = [&](const ApproximatePoint& c) {
      return e.dx * (c.y - corner_y) - e.dy * (c.x - corner_x);
    };
    const double dx = to.x - from.x, dy = to.y - from.y;
    // The right normal n has [n, f] = d f and [e, n] = -d e.
    if (!beside_strip(low, high, along_e(from), along_e(to), dx * f.dx + dy * f.dy) &&
        !beside_strip(low, high, along_f(from), along_f(to), -(dx * e.dx + dy * e.dy)))
      return false;
    ++effort.by_doubles;
    return true;
  }

  /// The same as certainly_outside() for the places between two on the segment, with regard to how large
  /// the numbers of this pair are: for where others are much larger.
  bool outside_closely(const ReducedSegment<Numbers>& segment, const EdgePair& pair,
                       const Fraction<Numbers>& first, const Fraction<Numbers>& last) {
    if (summands_.margins.area_is_exact) return false;
    if (digits_.are_needed()) return outside_by_digits(pair);
    const double from = first.near(), to = last.near();
    const NearSegment& e = summands_.p.near[pair.first];
    const NearSegment& f = summands_.q.near[pair.second];
    const double dx = segment.near.dx, dy = segment.near.dy;
    const auto is_beside_one = [&](const ApproximatePoint& corner) {
      const double most_x = std::abs(corner.x) + std::abs(dx) + 0x1p47 * corner.error;
      const double most_y = std::abs(corner.y) + std::abs(dy) + 0x1p47 * corner.error;
      const auto is_beside = [&](const NearSegment& along, const NearSegment& across) {
        const double area = std::abs(across.dx * along.dy - across.dy * along.dx);
        const auto place = [&](double t) {
          return (corner.x + t * dx) * along.dy - (corner.y + t * dy) * along.dx;
        };
        const double margin = 0x1p-47 * ((most_x + std::abs(across.dx)) * std::abs(along.dy) +
                                         (most_y + std::abs(across.dy)) * std::abs(along.dx)) +
                              0x1p-400;
        const bool turns_left = across.dx * along.dy > across.dy * along.dx;
        const double low = (turns_left ? 0 : -area) - margin;
        const double high = (turns_left ? area : 0) + margin;
        return std::max(place(from), place(to)) < low || std::min(place(from), place(to)) > high;
      };
      return is_beside(f, e) || is_beside(e, f);
    };
    const auto is_beside = [&] {
      if constexpr (!is_small<Numbers>) {
        const ApproximatePoint near =
            difference(difference({segment.near.x, segment.near.y, segment.error}, e), f);
        if (is_beside_one(near)) return true;
        // Exact differences would tell little more.
        if (near.error < 0x1p-30 * (std::abs(near.x) + std::abs(near.y))) return false;
      }
      const auto corner = segment.exact.source - summands_.p.edges[pair.first].source -
                          summands_.q.edges[pair.second].source;
      const std::size_t shift = summands_.margins.shift;
      return is_beside_one({near(corner.x, shift), near(corner.y, shift)});
    };
    if (!is_beside()) return false;
    ++effort.by_doubles;
    return true;
  }

  bool outside_by_digits(const EdgePair& pair) {
    if (!digits_.are_outside(pair)) return false;
    ++effort.by_doubles;
    return true;
  }

  /// Whether more than boxes shows that no place between two is in the sum of what two nodes are around. Boxes are
  /// enough for most searches: strips are only looked at in one that takes long.
  bool are_apart(const Pair& boxes, const ApproximatePoint& from,
                 const ApproximatePoint& to) const {
    if constexpr (!has_fixed_width<Numbers>)
      if (digits_.are_outside(boxes.first, boxes.second)) return true;
    return effort.box_pairs >= strips_from_ && beside_strips(boxes, from, to);
  }

  bool beside_strips(const Pair& boxes, const ApproximatePoint& from,
                     const ApproximatePoint& to) const {
    const FloatBoxTree::Node& a = summands_.tree_of_p[boxes.first];
    const FloatBoxTree::Node& b = summands_.tree_of_q[boxes.second];
    if (a.is_leaf() && b.is_leaf()) return false;  // certainly_outside() tells more
    return beside_strip(summands_.tree_of_p, a, summands_.p, b, summands_.q, from, to) ||
           beside_strip(summands_.tree_of_q, b, summands_.q, a, summands_.p, from, to);
  }

  /// The same with the strip around `node`, if it has one.
  static bool beside_strip(const FloatBoxTree& tree, const FloatBoxTree::Node& node,
                           const IntegerSummand<Numbers>& summand, const FloatBoxTree::Node& other,
                           const IntegerSummand<Numbers>& other_summand,
                           const ApproximatePoint& from, const ApproximatePoint& to) {
    const auto beside = [&](const Strip& strip) {
      return other.is_leaf() ? is_beside(strip, other_summand.near[other.edge], from, to)
                             : is_beside(strip, other.box, from, to);
    };
    // The line of a short edge separates little, and one along an axis no more than its box.
    if (node.is_leaf()) {
      const NearSegment& edge = summand.near[node.edge];
      return node.size > other.size && edge.dx != 0 && edge.dy != 0 && beside(strip_along(edge));
    }
    return node.strip != FloatBoxTree::none && beside(tree.strip(node.strip));
  }

  /// The interval of a pair, if it contains t.
  std::optional<Interval> containing(const ReducedSegment<Numbers>& segment,
                                     const Fraction<Numbers>& t, const ApproximatePoint& near,
                                     const EdgePair& pair) {
    if (comes_apart(segment, pair) || certainly_outside(pair, near, near) ||
        meets_end_only(segment, pair) || outside_closely(segment, pair, t, t))
      return std::nullopt;
    auto interval = interval_of(segment, pair);
    if (interval && interval->from < t && t < interval->to) return interval;
    return std::nullopt;
  }

  FloatBox sum_of(const Pair& boxes) const {
    return summands_.tree_of_p[boxes.first].box + summands_.tree_of_q[boxes.second].box;
  }

  EdgePair edges_in(const Pair& leaves) const {
    return {summands_.tree_of_p[leaves.first].edge, summands_.tree_of_q[leaves.second].edge};
  }

  struct Halves {
    Pair first;
    Pair second;
  };
  /// The larger of two boxes halved, each with the other. Nothing if they are leaves.
  std::optional<Halves> halves_of(const Pair& boxes) const {
    const auto [i, j] = boxes;
    const FloatBoxTree::Node& a = summands_.tree_of_p[i];
    const FloatBoxTree::Node& b = summands_.tree_of_q[j];
    if (a.is_leaf() && b.is_leaf()) return std::nullopt;
    if (b.is_leaf() || (!a.is_leaf() && a.size > b.size)) return Halves{{i + 1, j}, {a.right, j}};
    return Halves{{i, j + 1}, {i, b.right}};
  }

  /// From the middle of a box to a point, twice and by the coordinates' sum.
  static double distance(const FloatBox& box, const ApproximatePoint& to) {
    return std::abs(static_cast<double>(box[0] - box[2]) - 2 * to.x) +
           std::abs(static_cast<double>(box[1] - box[3]) - 2 * to.y);
  }

  void remember(const EdgePair& pair) {
    if (remembered_ < recent_.size()) ++remembered_;
    std::move_backward(recent_.begin(),
                       recent_.begin() + static_cast<std::ptrdiff_t>(remembered_) - 1,
                       recent_.begin() + static_cast<std::ptrdiff_t>(remembered_));
    recent_[0] = pair;
  }

  const IntegerSummands<Numbers>& summands_;
  Shift shift_;
  PlacesByDigits<Numbers> digits_;  ///< of what was asked about last
  std::array<EdgePair, 4> recent_;
  std::size_t remembered_ = 0;
  static constexpr std::size_t without_strips = 48;  ///< pairs of boxes
  std::size_t strips_from_ = 0;                      ///< when as many were opened
  std::array<Pair, 288> waiting_;                    ///< one a level of either tree
  ShortList<Pair> left_out_;                         ///< by the last probe
};

}  // namespace oplus::slide
