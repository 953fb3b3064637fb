// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <utility>

#include "checked/certificates/convex_pieces.hpp"
#include "checked/certificates/integer_line.hpp"
#include "checked/certificates/shifted_doubles.hpp"

namespace oplus::certificates {

/// Where a x + b y >= low, in doubles; (a, b) has the length 1.
struct HalfPlane {
  double a;
  double b;
  double low;

  double above(const Place& p) const { return a * p.x + b * p.y - low; }
};

/// The pieces of a summand in doubles, and boxes around halves of them.
class NearPieces {
 public:
  NearPieces(const ConvexPieces& pieces, const ShiftedDoubles& doubles);

  struct Piece {
    std::vector<Place> corners;
    std::vector<HalfPlane> sides;  ///< side k leaves corner k
  };
  struct Box {
    Place low;
    Place high;
  };

  const Piece& operator[](std::uint32_t i) const { return pieces_[i]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(pieces_.size()); }

  /// Some pieces, with the first of their boxes: one around all, then those of either half.
  struct Range {
    std::uint32_t begin, end;
    std::uint32_t box;

    bool is_one() const { return end - begin == 1; }
    std::pair<Range, Range> halves() const {
      const auto middle = begin + static_cast<std::uint32_t>(first_half(end - begin));
      return {{begin, middle, box + 1}, {middle, end, box + 2 * (middle - begin)}};
    }
  };
  /// Requires: there are pieces.
  Range all() const { return {0, size(), 0}; }
  const Box& box(const Range& range) const { return boxes_[range.box]; }

 private:
  void add_boxes(const Range& range);

  std::vector<Piece> pieces_;
  std::vector<Box> boxes_;
};

/// The sums of a convex piece T of P and one, U, of Q. Side k of T ⊕ U is in the direction of side k of T, and
/// those of U follow.
class PieceSums {
 public:
  PieceSums(const ConvexPieces& p, const ConvexPieces& q, const ShiftedDoubles& doubles);

  struct Pair {
    std::uint32_t i, j;
    friend bool operator==(const Pair&, const Pair&) = default;
  };

  /// Calls with all pairs that contain a place, or nearly: in boxes that are larger by a margin.
  template <typename Call>
  void for_each_box_around(const Place& place, double margin, const Call& call) const {
    if (p_.size() > 0 && q_.size() > 0) visit(place, margin, p_.all(), q_.all(), call);
  }

  /// The half planes of T ⊕ U, each off by a few roundings of the largest coordinates.
  void sides(const Pair& pair, std::vector<HalfPlane>& result) const;

  /// The same of one, exactly.
  const IntegerLine& exact_side(const Pair& pair, std::size_t side);

 private:
  template <typename Call>
  void visit(const Place& place, double margin, const NearPieces::Range& of_p,
             const NearPieces::Range& of_q, const Call& call) const {
    const NearPieces::Box &a = p_.box(of_p), &b = q_.box(of_q);
    if (place.x + margin < a.low.x + b.low.x || place.x - margin > a.high.x + b.high.x ||
        place.y + margin < a.low.y + b.low.y || place.y - margin > a.high.y + b.high.y)
      return;
    if (of_p.is_one() && of_q.is_one()) {
      call(Pair{of_p.begin, of_q.begin});
    } else if (of_q.is_one() || (!of_p.is_one() && size(a) >= size(b))) {
      const auto [first, second] = of_p.halves();
      visit(place, margin, first, of_q, call);
      visit(place, margin, second, of_q, call);
    } else {
      const auto [first, second] = of_q.halves();
      visit(place, margin, of_p, first, call);
      visit(place, margin, of_p, second, call);
    }
  }
  static double size(const NearPieces::Box& box) {
    return (box.high.x - box.low.x) + (box.high.y - box.low.y);
  }

  IntegerLine computed_side(const Pair& pair, std::size_t side) const;

  const ConvexPieces& exact_p_;
  const ConvexPieces& exact_q_;
  NearPieces p_;
  NearPieces q_;
  std::unordered_map<std::uint64_t, std::vector<std::pair<bool, IntegerLine>>> exact_sides_;
};

}  // namespace oplus::certificates
