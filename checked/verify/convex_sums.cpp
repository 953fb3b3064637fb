// SPDX-License-Identifier: MIT
#include "checked/verify/convex_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "checked/arithmetic/leave_out_copies.hpp"
#include "checked/arithmetic/set_integer.hpp"
#include "checked/verify/summand_parts.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/cyclic_order.hpp"
#include "reference/definitions/direction.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using convex_parts::Corner;
using convex_parts::Line;
using convex_parts::Piece;
using convex_parts::Side;
using convex_parts::SummandParts;

/// Where directions are in their cyclic order, without computing: equal ones have equal ranks, and
/// opposite ones are `half` apart.
struct Ranks {
  int half = 1;

  int opposite(int rank) const { return rank < half ? rank + half : rank - half; }

  /// Whether the cross product is positive.
  bool is_left_turn(int from, int to) const {
    const int ahead = to < from ? to - from + 2 * half : to - from;
    return 0 < ahead && ahead < half;
  }
};

/// How far along a segment, from 0 to 1: where it meets the line of one summand, moved by a corner of
/// the other, or a number.
struct End {
  double low;
  double high;
  double numerator;    ///< the exact quotient, where `is_quotient`: integers
  double denominator;  ///< positive
  bool is_quotient;
  const Line* line = nullptr;
  const Corner* corner = nullptr;
  const Rational* number = nullptr;
};

/// Requires: the denominator is positive.
Rational quotient(Integer128 numerator, std::int64_t denominator) {
  const auto whole = static_cast<std::uint64_t>(denominator);
  const auto absolute = static_cast<Unsigned128>(numerator < 0 ? -numerator : numerator);
  const std::uint64_t common = std::gcd(static_cast<std::uint64_t>(absolute % whole), whole);
  Rational result;
  set_integer(result.get_num_mpz_t(), numerator / common);
  set_integer(result.get_den_mpz_t(), whole / common);
  return result;
}

/// Whether it is two integers below 2^23.
bool is_small(const Corner& corner) {
  const auto small = [](const Rational& exact, const Interval& near) {
    return std::abs(near.low) < 0x1p23 && exact.get_den() == 1;
  };
  return small(corner.point.x, corner.near.x) && small(corner.point.y, corner.near.y);
}

End whole(double number) { return {number, number, number, 1, true}; }

struct Gap {
  End from;
  End to;
};

}  // namespace

class ConvexSums::Search {
 public:
  Search(const Region& p, const Region& q) : parts_{SummandParts(p), SummandParts(q)} {
    rank_directions();
    for (const SummandParts& part : parts_)
      for (const Corner& corner : part.corners) are_small_ = are_small_ && is_small(corner);
  }

  std::vector<EdgeAtVertex> reduced_convolution() const {
    std::vector<EdgeAtVertex> result;
    for (const Summand edge_of : {Summand::P, Summand::Q}) {
      const SummandParts& of_edge = part(edge_of);
      const SummandParts& of_vertex = part(other(edge_of));
      std::vector<std::size_t> order(of_edge.corners.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return of_edge.lines[a].rank < of_edge.lines[b].rank;
      });
      const auto first_from = [&](int rank) {
        return std::lower_bound(order.begin(), order.end(), rank,
                                [&](std::size_t e, int r) { return of_edge.lines[e].rank < r; });
      };
      for (std::size_t v = 0; v < of_vertex.corners.size(); ++v) {
        // Of equal directions that of Q comes after that of P (thesis, Definition 2.2.7).
        const int in = of_vertex.lines[of_vertex.before[v]].rank;
        const int out = of_vertex.lines[v].rank;
        if (!ranks_.is_left_turn(in, out)) continue;
        const int after = edge_of == Summand::P ? 1 : 0;
        const auto from = first_from(in + after);
        const auto to = first_from(out + after);
        const auto first_of_vertex = static_cast<std::ptrdiff_t>(result.size());
        const auto add = [&](auto begin, auto end) {
          for (auto e = begin; e != end; ++e) result.push_back({edge_of, *e, v});
        };
        if (in < out) {
          add(from, to);
        } else {
          add(from, order.end());
          add(order.begin(), to);
        }
        // Along the boundary: what covers one often covers the next.
        std::sort(result.begin() + first_of_vertex, result.end(),
                  [](const EdgeAtVertex& a, const EdgeAtVertex& b) { return a.edge < b.edge; });
      }
    }
    leave_out_copies(result);
    return result;
  }

  Segment segment(const EdgeAtVertex& candidate) const {
    const Line& edge = part(candidate.edge_of).lines[candidate.edge];
    const Point& vertex = part(other(candidate.edge_of)).corners[candidate.vertex].point;
    return {edge.from->point + vertex, edge.to->point + vertex};
  }

  std::vector<Segment> boundary_parts(const EdgeAtVertex& candidate) {
    start(candidate);
    std::vector<Segment> result;
    for (const Gap& gap : uncovered({whole(0), whole(1)}, true)) result.push_back(between(gap));
    return result;
  }

  Outside outside_parts(const EdgeAtVertex& candidate) {
    start(candidate);
    Outside result;
    for (const Gap& gap : uncovered({whole(0), whole(1)}, false)) {
      if (compare(gap.from, gap.to) == 0) {
        result.points.push_back(place(gap.from));
        continue;
      }
      End from = gap.from;
      const auto inside_until = [&](const End& to) {
        if (compare(from, to) < 0 &&
            !OPLUS_MUTANT("verify-sees-no-dangling-edges",
                          "verify finds no parts with the sum on both sides"))
          result.inside_closed_sum.push_back(between({from, to}));
      };
      for (const Gap& boundary : uncovered(gap, true)) {
        inside_until(boundary.from);
        result.boundary.push_back(between(boundary));
        from = boundary.to;
      }
      inside_until(gap.to);
    }
    return result;
  }

  bool source_is_outside(const EdgeAtVertex& candidate) {
    start(candidate);
    return !uncovered({whole(0), whole(0)}, false).empty();
  }

 private:
  const SummandParts& part(Summand s) const { return parts_[static_cast<std::size_t>(s)]; }

  /// Where doubles show it.
  void leave_out_copies(std::vector<EdgeAtVertex>& candidates) const {
    if (!are_small_) return;
    std::vector<std::size_t> edges_of_rank(2 * static_cast<std::size_t>(ranks_.half));
    for (const SummandParts& part : parts_)
      for (std::size_t e = 0; e < part.corners.size(); ++e)
        ++edges_of_rank[static_cast<std::size_t>(part.lines[e].rank)];
    const auto edge = [&](const EdgeAtVertex& candidate) -> const Line& {
      return part(candidate.edge_of).lines[candidate.edge];
    };
    oplus::leave_out_copies(
        candidates,
        [&](const EdgeAtVertex& candidate) {
          return edges_of_rank[static_cast<std::size_t>(edge(candidate).rank)] > 1;
        },
        [&](const EdgeAtVertex& candidate) {
          const IntervalPoint& along = edge(candidate).near_along;
          const IntervalPoint from = edge(candidate).from->near +
                                     part(other(candidate.edge_of)).corners[candidate.vertex].near;
          return std::array{from.x.low, from.y.low, along.x.low, along.y.low};
        });
  }

  /// All directions and their opposites.
  void rank_directions() {
    struct Upwards {
      Line* line;
      bool is_turned;      ///< if its direction is not in [0, π)
      IntervalPoint near;  ///< its direction, or the opposite one
    };
    std::vector<Upwards> all;
    for (SummandParts& part : parts_) {
      for (Line& line : part.lines) {
        const IntervalPoint& near = line.near_along;
        const bool is_turned = near.y.low > 0    ? false
                               : near.y.high < 0 ? true
                                                 : cyclic_order::half(line.along()) == 1;
        all.push_back({&line, is_turned, is_turned ? IntervalPoint{} - near : near});
      }
    }
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), 0);
    const auto turn = [&](std::size_t a, std::size_t b) {
      const IntervalPoint origin{};
      const std::optional<int> known = orientation(origin, all[a].near, all[b].near);
      if (known) return *known;
      const int exact = sign(cross(all[a].line->along(), all[b].line->along()));
      return all[a].is_turned == all[b].is_turned ? exact : -exact;
    };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return turn(a, b) > 0; });
    int rank = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i > 0 && turn(order[i - 1], order[i]) > 0) ++rank;
      all[order[i]].line->rank = rank;
    }
    ranks_.half = rank + 1;
    for (const Upwards& u : all)
      if (u.is_turned) u.line->rank += ranks_.half;
    for (SummandParts& part : parts_) {
      for (Side& side : part.sides)
        side.rank =
            side.start == side.line->from ? side.line->rank : ranks_.opposite(side.line->rank);
      for (const Piece& piece : part.pieces) {
        const auto sides = std::span(part.sides).subspan(piece.first, piece.count);
        std::rotate(sides.begin(), std::ranges::is_sorted_until(sides, {}, &Side::rank),
                    sides.end());
      }
    }
  }

  void start(const EdgeAtVertex& candidate) {
    const SummandParts& of_edge = part(candidate.edge_of);
    const SummandParts& of_vertex = part(other(candidate.edge_of));
    along_ = &of_edge.lines[candidate.edge];
    by_ = &of_vertex.corners[candidate.vertex];
    source_.reset();
    near_source_ = along_->from->near + by_->near;
  }

  const Point& source() {
    if (!source_) source_ = along_->from->point + by_->point;
    return *source_;
  }

  Rational exact(const End& end) {
    if (end.number != nullptr) return *end.number;
    if (end.line == nullptr) return Rational(end.numerator) / Rational(end.denominator);
    const Vector u = end.line->along();
    return cross(u, end.line->from->point + end.corner->point - source()) /
           cross(u, along_->along());
  }

  int compare(const End& a, const End& b) {
    if (a.high < b.low) return -1;
    if (a.low > b.high) return 1;
    if (a.line == b.line && a.corner == b.corner && a.line != nullptr) return 0;
    if (a.is_quotient && b.is_quotient) {
      const auto product = [](double x, double y) {
        return static_cast<Integer128>(static_cast<std::int64_t>(x)) * static_cast<std::int64_t>(y);
      };
      const Integer128 left = product(a.numerator, b.denominator);
      const Integer128 right = product(b.numerator, a.denominator);
      return (left > right) - (left < right);
    }
    return cmp(exact(a), exact(b));
  }

  /// Of an end of a gap: it is 0 or 1, or where lines cross.
  Point place(const End& end) {
    if (are_small_) {
      // The numerator is below 2^50, the denominator below 2^49, coordinates are below 2^24.
      const auto numerator = static_cast<std::int64_t>(end.numerator);
      const auto denominator = static_cast<std::int64_t>(end.denominator);
      const auto coordinate = [&](const Interval& source, const Interval& along) {
        return quotient(static_cast<Integer128>(source.low) * denominator +
                            static_cast<Integer128>(along.low) * numerator,
                        denominator);
      };
      return {coordinate(near_source_.x, along_->near_along.x),
              coordinate(near_source_.y, along_->near_along.y)};
    }
    if (end.line == nullptr) return end.low == 0 ? source() : along_->to->point + by_->point;
    return source() + exact(end) * along_->along();
  }
  Segment between(const Gap& gap) { return {place(gap.from), place(gap.to)}; }

  /// The cross product of u and x - a - b.
  Interval near_cross(const IntervalPoint& u, const IntervalPoint& x, const IntervalPoint& a,
                      const IntervalPoint& b) const {
    if (!are_small_) return cross(u, x - a - b);
    const double exact =
        u.x.low * (x.y.low - a.y.low - b.y.low) - u.y.low * (x.x.low - a.x.low - b.x.low);
    return {exact, exact};
  }

  End crossing(const Line& line, const Corner& corner) const {
    // At an end of the segment, where doubles would not decide.
    if (&corner == by_) {
      if (line.ends_at(along_->from)) return whole(0);
      if (line.ends_at(along_->to)) return whole(1);
    }
    if (along_->ends_at(&corner) && line.ends_at(by_)) return whole(&corner == along_->to);
    // On which side of the moved line the segment's source is, times a length, and how fast it moves.
    Interval side = near_cross(line.near_along, near_source_, line.from->near, corner.near);
    Interval speed = near_cross(line.near_along, along_->near_along, {}, {});
    if (speed.low >= 0)
      side = -side;
    else
      speed = -speed;
    const Interval at = side / speed;
    End end{at.low, at.high, side.low, speed.low, false, &line, &corner};
    end.is_quotient = are_small_;
    return end;
  }

  /// On which side of the segment the sum of two corners is: positive to the left.
  int side_of(const Corner& a, const Corner& b) {
    if ((&a == by_ && along_->ends_at(&b)) || (&b == by_ && along_->ends_at(&a))) return 0;
    const std::optional<int> known =
        oplus::sign(near_cross(along_->near_along, near_source_, a.near, b.near));
    if (known) return -*known;
    return sign(cross(along_->along(), a.point + b.point - source()));
  }

  /// A convex part, its sides counted from one of them on, around and around.
  struct Walk {
    const Side* sides;
    std::uint32_t count;
    std::uint32_t first = 0;

    const Side& operator[](std::uint32_t i) const {
      const std::uint32_t place = first + i;
      return sides[place < count ? place : place - count];
    }

    /// The number of sides from the first one to the next of at least this rank, or, if `past`, of a
    /// larger one.
    std::uint32_t until(int rank, bool past = false) const {
      const Side* const found =
          std::lower_bound(sides, sides + count, rank + (past ? 1 : 0),
                           [](const Side& side, int r) { return side.rank < r; });
      const auto place = found == sides + count ? 0 : static_cast<std::uint32_t>(found - sides);
      return place < first ? place + count - first : place - first;
    }
    Walk from(int rank, bool past) const {
      return {sides, count, Walk{sides, count}.until(rank, past)};
    }
  };

  Walk walk(const SummandParts& part, const Piece& piece) const {
    return {&part.sides[piece.first], piece.count};
  }

  /// The smallest number in (low, high] of which something holds that also holds of all larger ones. Of
  /// `high` it is not asked.
  template <typename Holds>
  static std::uint32_t first_in(std::uint32_t low, std::uint32_t high, const Holds& holds) {
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      (holds(middle) ? high : low) = middle;
    }
    return high;
  }

  /// Where the boundary of the sum of two parts passes the segment, from where two walks start, on one side of
  /// it, to where their sides turn as far as `to`, beyond it. The sides of the sum are those of both parts in the
  /// order of their directions, so binary search finds the one that ends beyond.
  template <typename IsBeyond>
  End passing(const Walk& t, const Walk& u, int to, const IsBeyond& is_beyond) {
    const std::uint32_t sides_of_t = t.until(to), sides_of_u = u.until(to);
    // After side i - 1 of t, those of u that turn less far are passed.
    const auto with = [&](std::uint32_t i) { return u.until(t[i - 1].rank); };
    const std::uint32_t i = first_in(0, sides_of_t + 1, [&](std::uint32_t k) {
      return is_beyond(*t[k].start, *u[with(k)].start);
    });
    const std::uint32_t low = i == 1 ? 0 : with(i - 1);
    const std::uint32_t high = i > sides_of_t ? sides_of_u : with(i);
    const Corner& of_t = *t[i - 1].start;
    if (high > low && (i > sides_of_t || is_beyond(of_t, *u[high].start))) {
      const std::uint32_t j =
          first_in(low, high, [&](std::uint32_t k) { return is_beyond(of_t, *u[k].start); });
      return crossing(*u[j - 1].line, of_t);
    }
    const std::uint32_t corner =
        OPLUS_MUTANT("sides-of-convex-sums-start-anywhere",
                     "verify moves a side of a convex part by the wrong corner of the other")
            ? high + 1
            : high;
    return crossing(*t[i - 1].line, *u[corner].start);
  }

  /// Finds where a segment is inside the sum of two pieces; sets low_ and high_.
  bool meets(const Piece& of_p, const Piece& of_q) {
    low_.reset();
    high_.reset();
    const Walk t = walk(parts_[0], of_p), u = walk(parts_[1], of_q);
    const int along = along_->rank, back = ranks_.opposite(along);
    // The corners that are furthest to the right of the segment, and to its left.
    if (side_of(*t[t.until(along)].start, *u[u.until(along)].start) >= 0) return false;
    const int left = side_of(*t[t.until(back)].start, *u[u.until(back)].start);
    // A segment along a side, with the sum to its right, is inside it if it is moved there.
    const bool may_run_along =
        beside_ &&
        !OPLUS_MUTANT(
            "edges-of-convex-sums-count-on-neither-side",
            "verify takes what is beside a segment for outside a convex sum on its right");
    if (left < 0 || (left == 0 && !may_run_along)) return false;
    low_ = passing(t.from(back, true), u.from(back, true), along,
                   [&](const Corner& a, const Corner& b) { return side_of(a, b) < 0; });
    high_ = passing(t.from(along, true), u.from(along, true), back,
                    [&](const Corner& a, const Corner& b) { return side_of(a, b) >= 0; });
    return compare(*low_, *high_) < 0;
  }

  /// Whether the convex sum of two pieces contains the probe. If not, what it contains of the window
  /// is taken away.
  bool covers(std::uint32_t i, std::uint32_t j) {
    if (!meets(parts_[0].pieces[i], parts_[1].pieces[j])) return false;
    const int from = compare(*low_, probe_);
    if (from < 0 && compare(probe_, *high_) < 0) return true;
    if (from < 0) {  // before the probe
      if (compare(*high_, window_.from) > 0) {
        window_.from = *high_;
        rest_before_ = low_;
        set_reach();
      }
    } else if (compare(*low_, window_.to) < 0) {
      window_.to = *low_;
      rest_after_ = high_;
      set_reach();
    }
    return false;
  }

  /// A box around the part of the segment in the window.
  void set_reach() {
    const Interval part{std::max(window_.from.low, 0.0), std::min(window_.to.high, 1.0)};
    const Interval x = near_source_.x + part * along_->near_along.x;
    const Interval y = near_source_.y + part * along_->near_along.y;
    reach_ = box_of(IntervalPoint{x, y});
  }

  /// False only if no point of the segment in the window is in a sum of the two boxes.
  bool may_meet(const Box& a, const Box& b) const {
    const Box sum = a + b;
    if (!meet(sum, reach_)) return false;
    const double half_x = (sum.high_x - sum.low_x) / 2, half_y = (sum.high_y - sum.low_y) / 2;
    const double x = (sum.low_x / 2 + sum.high_x / 2) - near_source_.x.low;
    const double y = (sum.low_y / 2 + sum.high_y / 2) - near_source_.y.low;
    const double dx = along_->near_along.x.low, dy = along_->near_along.y.low;
    const auto error = [](double low, double high, const Interval& source) {
      return 0x1p-45 * (std::abs(low) + std::abs(high) + std::abs(source.low)) +
             (source.high - source.low);
    };
    const double error_x = error(sum.low_x, sum.high_x, near_source_.x);
    const double error_y = error(sum.low_y, sum.high_y, near_source_.y);
    return !(std::abs(dx * y - dy * x) > std::abs(dx) * (half_y + error_y) * (1 + 0x1p-40) +
                                             std::abs(dy) * (half_x + error_x) * (1 + 0x1p-40) +
                                             0x1p-40 * (std::abs(dx * y) + std::abs(dy * x)));
  }

  bool has_probe(const Box& a, const Box& b) const {
    return meet(a + b, {probe_x_, probe_y_, probe_x_, probe_y_});
  }

  /// Finds a pair that covers the probe: then low_ and high_ are where. Otherwise the window becomes
  /// what no pair covers around the probe.
  bool find_cover(const End& probe) {
    probe_ = probe;
    const double t = (probe.low + probe.high) / 2;
    probe_x_ = near_source_.x.low + t * along_->near_along.x.low;
    probe_y_ = near_source_.y.low + t * along_->near_along.y.low;
    set_reach();
    for (auto pair = recent_.begin(); pair != recent_.end(); ++pair) {
      if (!covers(pair->first, pair->second)) continue;
      std::rotate(recent_.begin(), pair, pair + 1);
      return true;
    }

    const BoxTree<>&ps = parts_[0].boxes, &qs = parts_[1].boxes;
    if (ps.empty() || qs.empty()) return false;
    near_.assign(1, {ps.all(), qs.all()});
    later_.clear();
    while (!near_.empty() || !later_.empty()) {
      std::vector<Ranges>& pending = near_.empty() ? later_ : near_;
      const auto [a, b] = pending.back();
      pending.pop_back();
      if (!may_meet(ps[a], qs[b])) continue;
      if (a.is_leaf() && b.is_leaf()) {
        if (covers(a.begin, b.begin)) {
          std::rotate(recent_.begin(), recent_.end() - 1, recent_.end());
          recent_.front() = {a.begin, b.begin};
          return true;
        }
        continue;
      }
      Ranges first{a, b}, second{a, b};
      if (b.is_leaf() || (!a.is_leaf() && ps.slack(a) > qs.slack(b)))
        std::tie(first.first, second.first) = a.halves();
      else
        std::tie(first.second, second.second) = b.halves();
      const auto distance = [&](const Ranges& ranges) {
        const Box sum = ps[ranges.first] + qs[ranges.second];
        return std::abs((sum.low_x + sum.high_x) / 2 - probe_x_) +
               std::abs((sum.low_y + sum.high_y) / 2 - probe_y_);
      };
      if (distance(first) < distance(second)) std::swap(first, second);
      for (const Ranges& ranges : {first, second})
        (has_probe(ps[ranges.first], qs[ranges.second]) ? near_ : later_).push_back(ranges);
    }
    return false;
  }

  /// A number inside a gap, with few digits if the gap is not short.
  End inside(const Gap& gap) {
    const double from = std::max(gap.from.high, 0.0);
    const double to = std::min(gap.to.low, 1.0);
    const double middle = from + 0.4716796875 * (to - from);
    const double scaled = std::floor(middle * 0x1p30);
    if (from < scaled * 0x1p-30 && scaled * 0x1p-30 < to)
      return {scaled * 0x1p-30, scaled * 0x1p-30, scaled, 0x1p30, true};
    if (from < middle && middle < to) return {middle, middle, middle, 1, false};
    middle_ = (exact(gap.from) + exact(gap.to)) / 2;
    return {gap.from.low, gap.to.high, 0, 1, false, nullptr, nullptr, &middle_};
  }

  /// The closed parts of a gap that are in no open convex sum; if `beside`, those that are so after a
  /// shift to the right of the segment by an infinitesimal, except points. Sorted.
  std::vector<Gap> uncovered(const Gap& all, bool beside) {
    beside_ = beside;
    std::vector<Gap> result;
    gaps_.assign(1, all);
    while (!gaps_.empty()) {
      const Gap gap = gaps_.back();
      gaps_.pop_back();
      const int order = compare(gap.from, gap.to);
      const bool points_count =
          !beside && !OPLUS_MUTANT("points-between-convex-sums-are-inside",
                                   "verify takes a point between two convex sums that touch there "
                                   "for inside the sum");
      if (order > 0 || (order == 0 && !points_count)) continue;
      window_ = gap;
      rest_before_.reset();
      rest_after_.reset();
      if (find_cover(order == 0 ? gap.from : inside(gap))) {
        rest_before_ = low_;
        rest_after_ = high_;
      } else {
        result.push_back(window_);
      }
      if (rest_before_) gaps_.push_back({gap.from, *rest_before_});
      if (rest_after_) gaps_.push_back({*rest_after_, gap.to});
    }
    std::sort(result.begin(), result.end(),
              [&](const Gap& a, const Gap& b) { return compare(a.from, b.from) < 0; });
    return result;
  }

  std::array<SummandParts, 2> parts_;
  Ranks ranks_;
  bool are_small_ = true;  ///< integers for which doubles are exact

  // Of the segment.
  const Line* along_ = nullptr;
  const Corner* by_ = nullptr;
  IntervalPoint near_source_;
  std::optional<Point> source_;

  // Of the search.
  bool beside_ = false;
  std::vector<Gap> gaps_;
  Gap window_{};
  std::optional<End> rest_before_, rest_after_;
  Box reach_;
  End probe_{};
  double probe_x_ = 0, probe_y_ = 0;
  Rational middle_;
  std::optional<End> low_, high_;
  std::array<std::pair<std::uint32_t, std::uint32_t>, 8>
      recent_{};  ///< that covered a probe, the last one first
  using Ranges = std::pair<BoxTree<>::Range, BoxTree<>::Range>;
  std::vector<Ranges> near_, later_;
};

ConvexSums::ConvexSums(const Region& p, const Region& q) : search_(new Search(p, q)) {}

ConvexSums::~ConvexSums() = default;

std::vector<ConvexSums::EdgeAtVertex> ConvexSums::reduced_convolution() const {
  return search_->reduced_convolution();
}

Segment ConvexSums::segment(const EdgeAtVertex& candidate) const {
  return search_->segment(candidate);
}

std::vector<Segment> ConvexSums::boundary_parts(const EdgeAtVertex& candidate) {
  return search_->boundary_parts(candidate);
}

ConvexSums::Outside ConvexSums::outside_parts(const EdgeAtVertex& candidate) {
  return search_->outside_parts(candidate);
}

bool ConvexSums::source_is_outside(const EdgeAtVertex& candidate) {
  return search_->source_is_outside(candidate);
}

}  // namespace oplus
