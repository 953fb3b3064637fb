// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "checked/collision/segment_tree.hpp"
#include "reference/definitions/direction.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// A summand and the pieces of its boundary, which meet at common ends only and have its interior
/// to their left (pieces_by_chain).
struct SummandBoundary {
  explicit SummandBoundary(const Region& of);

  std::vector<std::uint32_t> chain_of;  ///< of each piece
  std::vector<Point> vertex_of_chain;   ///< one vertex each
  SegmentTree vertices;                 ///< those of `vertex_of_chain`
  SegmentTree around;                   ///< one box around all pieces
  SegmentTree pieces;

  /// Whether a point that is on no piece is inside: whether it is to the left of the first piece to the right
  /// of it. O(log n) in practice.
  bool contains(const Point& x) const;

 private:
  explicit SummandBoundary(std::vector<std::vector<Segment>> of_chains);
};

inline Segment translated(const Segment& s, const Vector& by) {
  return {s.source + by, s.target + by};
}

/// For each summand, which of its chains have a point in common with the other's boundary.
using TouchedChains = std::array<std::vector<bool>, 2>;

/// Returns the chains of both summands, none of them touched.
TouchedChains untouched(const SummandBoundary& p, const SummandBoundary& minus_q);

/// Whether the interiors of P and -Q+x meet, where no crossing and no contact shows that they do.
/// Then a chain that touches the other boundary runs outside the other interior; one that does not
/// is inside or outside as a whole, as one vertex is.
bool one_contains_untouched_chain(const SummandBoundary& p, const SummandBoundary& minus_q,
                                  const Point& x, const TouchedChains& touched);

}  // namespace oplus
