// SPDX-License-Identifier: MIT
#include "checked/pieces/balanced_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/definitions/region.hpp"

namespace oplus::pieces {

namespace {

/// What remains to be divided, and how.
class Division {
 public:
  Division(std::uint32_t most_corners, std::span<const Place> places,
           std::vector<ConvexPiece>& pieces)
      : most_(most_corners), places_(places), pieces_(pieces) {}

  void run(ConvexRing whole) {
    const auto x = [&](std::uint32_t corner) { return places_[corner].x; };
    const auto y = [&](std::uint32_t corner) { return places_[corner].y; };
    const auto [left, right] = std::ranges::minmax_element(whole.corners, {}, x);
    const auto [lower, upper] = std::ranges::minmax_element(whole.corners, {}, y);
    is_wide_ = x(*right) - x(*left) >= y(*upper) - y(*lower);
    open_.push_back(std::move(whole));
    while (!open_.empty()) {
      const ConvexRing ring = std::move(open_.back());
      open_.pop_back();
      if (ring.corners.size() <= most_)
        add_piece(ring);
      else if (ring.corners.size() <= most_of_slab * most_ &&
               std::ranges::find(ring.is_flat, true) == ring.is_flat.end())
        divide_cap(ring.corners);
      else
        halve(ring);
    }
  }

 private:
  /// Boxes around caps reach far beyond the polygon where they are large, those around slabs do not; but slabs cross many
  /// of the other summand.
  static constexpr std::size_t most_of_slab = 32;

  /// From a corner whose triangles with two that follow each other are counterclockwise: neither next to it is
  /// flat. If a side has one flat corner, that is one; else all sides but one have none.
  void add_piece(const ConvexRing& ring) {
    const std::size_t size = ring.corners.size();
    std::size_t first = 0;
    while (ring.is_flat[next(first, size)] || ring.is_flat[previous(first, size)]) ++first;
    ConvexPiece piece = ring.corners;
    std::rotate(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(first), piece.end());
    pieces_.push_back(std::move(piece));
  }

  /// How many pieces there are at least.
  std::size_t count(std::size_t corners) const { return (corners - 2 + most_ - 3) / (most_ - 2); }

  /// Without flat corners: the piece at the side from the last corner to the first has the others evenly, so that what is
  /// beyond its other sides are as many caps, which are divided likewise.
  void divide_cap(std::span<const std::uint32_t> corners) {
    const std::size_t beyond = count(corners.size()) - 1, caps = most_ - 1;
    if (beyond == 0) {
      pieces_.emplace_back(corners.begin(), corners.end());
      return;
    }
    ConvexPiece piece = {corners.front()};
    std::size_t from = 0;
    for (std::size_t k = 0; k < caps; ++k) {
      const std::size_t share = beyond * (k + 1) / caps - beyond * k / caps;
      const std::size_t to = k + 1 < caps ? from + share * (most_ - 2) + 1 : corners.size() - 1;
      piece.push_back(corners[to]);
      if (to - from > 1) divide_cap(corners.subspan(from, to - from + 1));
      from = to;
    }
    pieces_.push_back(std::move(piece));
  }

  /// By that one of the diagonals with half of the pieces on either side which runs most directly across the whole. One of
  /// them at least is not along a side, since there are three sides.
  void halve(const ConvexRing& ring) {
    const std::size_t size = ring.corners.size();
    const std::size_t steps = count(size) / 2 * (most_ - 2) + 1;
    std::vector<std::size_t> turns = {0};  // before each corner, twice round
    for (std::size_t k = 0; k < 2 * size; ++k)
      turns.push_back(turns.back() + (ring.is_flat[k % size] ? 0 : 1));
    const auto is_along_side = [&](std::size_t from, std::size_t to) {
      return turns[to] == turns[from + 1];
    };
    double least = std::numeric_limits<double>::infinity();
    std::size_t from = size;
    for (std::size_t k = 0; k < size; ++k) {
      if (is_along_side(k, k + steps) || is_along_side(k + steps, k + size)) continue;
      const Place& a = places_[ring.corners[k]];
      const Place& b = places_[ring.corners[(k + steps) % size]];
      const double width = std::abs(is_wide_ ? a.x - b.x : a.y - b.y);
      if (from != size && width >= least) continue;
      least = width;
      from = k;
    }
    open_.push_back(part(ring, from, from + steps));
    open_.push_back(part(ring, from + steps, from + size));
  }

  /// At the ends of a diagonal, both parts have convex corners.
  static ConvexRing part(const ConvexRing& ring, std::size_t from, std::size_t to) {
    ConvexRing result;
    for (std::size_t k = from; k <= to; ++k) {
      result.corners.push_back(ring.corners[k % ring.corners.size()]);
      result.is_flat.push_back(k != from && k != to && ring.is_flat[k % ring.corners.size()]);
    }
    return result;
  }

  const std::size_t most_;
  bool is_wide_ = true;
  const std::span<const Place> places_;
  std::vector<ConvexPiece>& pieces_;
  std::vector<ConvexRing> open_;
};

}  // namespace

void add_balanced_pieces(ConvexRing ring, std::uint32_t most_corners, std::span<const Place> places,
                         std::vector<ConvexPiece>& pieces) {
  Division(most_corners, places, pieces).run(std::move(ring));
}

}  // namespace oplus::pieces
