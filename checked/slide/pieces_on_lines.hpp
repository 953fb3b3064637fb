// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "checked/slide/open_places.hpp"

namespace oplus::slide {

/// Pieces of segments to the right, in the order of their lines and along them.
template <typename Numbers>
class PiecesOnLines {
 public:
  PiecesOnLines(const ReducedSegments<Numbers>& segments,
                const std::vector<FreePiece<Numbers>>& pieces, const Margins& margins)
      : margin_(4 * margins.point) {
    sorted_.reserve(pieces.size());
    for (const FreePiece<Numbers>& piece : pieces) sorted_.push_back(on_line(segments, piece));
    std::sort(sorted_.begin(), sorted_.end(), [&](const OnLine& a, const OnLine& b) {
      if (!is_same_line(a, b)) return key(a) < key(b);
      return compared(a.from, b.from) < 0;
    });
  }

  /// Some of the pieces, the union of which is that of all; on three of one line there is no point in common.
  std::vector<FreePiece<Numbers>> cover() const {
    std::vector<FreePiece<Numbers>> chosen;
    each_union([&](const auto& pieces) {
      for (const OnLine* piece : pieces) chosen.push_back(piece->piece);
    });
    return chosen;
  }

  /// Calls visit(first, last) with the pieces at both ends of each maximal connected union.
  template <typename Visit>
  void each_connected(const Visit& visit) const {
    each_union([&](const auto& pieces) { visit(pieces.front()->piece, pieces.back()->piece); });
  }

 private:
  using Value = typename Numbers::Value;

  /// A place on a line, by the first of its coordinates that changes along it.
  struct Position {
    Value source;
    Value direction;
    Fraction<Numbers> t;
    double near;
  };

  struct OnLine {
    IntegerVector<Numbers> direction;  ///< divided by its common factor
    Value line;                        ///< the skew product of the direction and each point
    Position from, to;
    FreePiece<Numbers> piece;
  };

  static auto key(const OnLine& a) { return std::tie(a.direction.x, a.direction.y, a.line); }

  static bool is_same_line(const OnLine& a, const OnLine& b) { return key(a) == key(b); }

  static OnLine on_line(const ReducedSegments<Numbers>& segments, const FreePiece<Numbers>& piece) {
    const ReducedSegment<Numbers> segment = segments[piece.segment];
    const IntegerVector<Numbers>& source = segment.exact.source;
    const IntegerVector<Numbers>& d = segment.exact.direction;
    const Value common = common_factor(d.x, d.y);
    const IntegerVector<Numbers> direction{d.x / common, d.y / common};
    const bool is_steep = d.x == 0;
    const auto position = [&](const Fraction<Numbers>& t) {
      const ApproximatePoint near = near_place(segment, t);
      return Position{is_steep ? source.y : source.x, is_steep ? d.y : d.x, t,
                      is_steep ? near.y : near.x};
    };
    return {direction, cross(direction, source), position(piece.piece.from),
            position(piece.piece.to), piece};
  }

  /// What directions are divided by, so that equal ones have equal numbers.
  static Value common_factor(const Value& a, const Value& b) {
    if constexpr (is_small<Numbers>)
      return std::gcd(a, b);
    else if constexpr (is_wide<Numbers>)
      return std::gcd(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
    else if constexpr (is_rational<Numbers>)
      return abs(a != 0 ? a : b);
    else
      return gcd(a, b);
  }

  int compared(const Position& a, const Position& b) const {
    if (std::abs(a.near - b.near) > margin_) return a.near < b.near ? -1 : 1;
    const Rational difference = exact(a) - exact(b);
    return sgn(difference);
  }

  static Rational exact(const Position& position) {
    return rational(position.source) + rational(position.direction) * rational(position.t);
  }

  /// Calls visit(pieces) with pieces that cover each maximal connected union, in order.
  template <typename Visit>
  void each_union(const Visit& visit) const {
    std::vector<const OnLine*> chosen;
    for (std::size_t i = 0; i < sorted_.size();) {
      // The one that reaches farthest of those that begin where the last one reaches, or before.
      const OnLine* best = &sorted_[i];
      const auto is_within_reach = [&](const OnLine& next) {
        return is_same_line(next, *best) &&
               compared(next.from, chosen.empty() ? sorted_[i].from : chosen.back()->to) <= 0;
      };
      std::size_t next = i + 1;
      for (; next < sorted_.size() && is_within_reach(sorted_[next]); ++next)
        if (compared(best->to, sorted_[next].to) < 0) best = &sorted_[next];
      if (chosen.empty() || compared(chosen.back()->to, best->to) < 0) chosen.push_back(best);
      i = next;
      if (i < sorted_.size() && is_same_line(sorted_[i], *chosen.back()) &&
          compared(sorted_[i].from, chosen.back()->to) <= 0)
        continue;
      visit(chosen);
      chosen.clear();
    }
  }

  double margin_;
  std::vector<OnLine> sorted_;
};

}  // namespace oplus::slide
