// SPDX-License-Identifier: MIT
#include "checked/repair/filled.hpp"

#include "checked/operations/winding_sweep.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

PlanarSet filled(const std::vector<Chain>& chains, FillRule rule) {
  SweptSets sets;
  for (const Chain& chain : chains) sets.add(chain);
  const auto is_inside = [&](int winding) {
    return rule == FillRule::even_odd &&
                   !OPLUS_MUTANT("even-odd-is-nonzero", "the rule even-odd is taken for nonzero")
               ? winding % 2 != 0
               : winding != 0;
  };
  BoundaryFeatures boundary;
  sweep_windings(
      sets,
      [&](const SweptPiece& piece) {
        const bool left = is_inside(piece.left);
        if (left != is_inside(piece.right))
          boundary.edges.push_back(left ? piece.segment : reversed(piece.segment));
      },
      [](const SweptPoint&) {});
  return canonical_sum(boundary);
}

}  // namespace oplus
