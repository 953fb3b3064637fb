// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "checked/boxes/box_tree.hpp"
#include "checked/certificates/cell.hpp"
#include "checked/pieces/convex_pieces.hpp"
#include "checked/pieces/shifted_doubles.hpp"

namespace oplus::certificates {

using pieces::ConvexPiece;
using pieces::ConvexPieces;

/// Where a x + b y >= low, in doubles; (a, b) has the length 1.
struct HalfPlane {
  double a;
  double b;
  double low;

  double above(const Place& p) const { return a * p.x + b * p.y - low; }
};

/// A piece of a summand in doubles.
struct NearPiece {
  std::vector<Place> corners;
  std::vector<HalfPlane> sides;  ///< side k leaves corner k
};

/// The pieces of a summand.
struct NearPieces {
  NearPieces(const ConvexPieces& exact, const ShiftedDoubles& doubles);

  const ConvexPieces& exact;
  std::vector<NearPiece> near;
  BoxTree<> boxes;
};

/// Thrown where a point of what should be a sum is in no sum of two pieces.
class PointOutsideSum : public std::logic_error {
 public:
  explicit PointOutsideSum(const Point& x);
};

/// The sums of a convex piece T of P and one, U, of Q. Side k of T ⊕ U is in the direction of side k of T, and
/// those of U follow.
class PieceSums {
 public:
  /// `largest`: no coordinate of what is asked for is larger, nor of a sum.
  PieceSums(const ConvexPieces& p, const ConvexPieces& q, const ShiftedDoubles& doubles,
            double largest)
      : p_(p, doubles), q_(q, doubles), error_(largest * 0x1p-44) {}

  struct Pair {
    std::uint32_t i, j;
    friend bool operator==(const Pair&, const Pair&) = default;
  };

  /// Calls with all pairs that contain a place, or nearly, in boxes that are larger by a margin, as long as it returns true.
  template <typename Call>
  void for_each_box_around(const Place& place, double margin, const Call& call) const {
    if (!p_.boxes.empty() && !q_.boxes.empty())
      visit(place, margin, p_.boxes.all(), q_.boxes.all(), call);
  }

  /// What is above a half plane by more than this is above its line.
  double error() const { return error_; }

  /// Pairs whose sums contain a place, or nearly: all; or where more than `most` have boxes around it, those among so many,
  /// and a few others.
  std::vector<Pair> pairs_around(const Place& x, std::size_t most = ~std::size_t{0}) const;

  /// Whether the sum of a pair contains a place, or nearly.
  bool is_near(const Pair& pair, const Place& x) const;

  /// The half planes of T ⊕ U, each off by a few roundings of the largest coordinates.
  void sides(const Pair& pair, std::vector<HalfPlane>& result) const;

  /// The same of one, exactly.
  const IntegerLine& exact_side(const Pair& pair, std::size_t side);

  /// 1 for a corner above the side, 0 on its line, -1 beyond. Doubles decide, or exact numbers where it is near the
  /// line. `half_plane` is that of the side.
  int side_of(const Pair& pair, std::size_t side, const HalfPlane& half_plane,
              const CellCorner& corner);

 private:
  template <typename Call>
  bool visit(const Place& place, double margin, const BoxTree<>::Range& of_p,
             const BoxTree<>::Range& of_q, const Call& call) const {
    const Box &a = p_.boxes[of_p], &b = q_.boxes[of_q], sum = a + b;
    if (place.x + margin < sum.low_x || place.x - margin > sum.high_x ||
        place.y + margin < sum.low_y || place.y - margin > sum.high_y)
      return true;
    if (of_p.is_leaf() && of_q.is_leaf()) {
      return call(Pair{of_p.begin, of_q.begin});
    } else if (of_q.is_leaf() || (!of_p.is_leaf() && a.size() >= b.size())) {
      const auto [first, second] = of_p.halves();
      return visit(place, margin, first, of_q, call) && visit(place, margin, second, of_q, call);
    } else {
      const auto [first, second] = of_q.halves();
      return visit(place, margin, of_p, first, call) && visit(place, margin, of_p, second, call);
    }
  }

  IntegerLine computed_side(const Pair& pair, std::size_t side) const;

  NearPieces p_;
  NearPieces q_;
  double error_;
  std::unordered_map<std::uint64_t, std::vector<std::pair<bool, IntegerLine>>> exact_sides_;
};

}  // namespace oplus::certificates
