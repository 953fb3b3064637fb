// SPDX-License-Identifier: MIT
#pragma once

#include "reference/io/placed_geometry.hpp"

#include "reference/chains/validity.hpp"

namespace oplus {

/// That components cross, overlap, share an edge or contain each other, which Overlaps::allowed takes.
class OverlappingComponents : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// Throws InvalidInput that names the chains, edges and vertices of a defect as the input has them:
/// numbered from one, in the input's order. The place is the later one of the two. Of two components it is
/// OverlappingComponents.
[[noreturn]] void refuse_defect(const InputText& input, const PlacedGeometry& geometry,
                                const Defect& defect);

}  // namespace oplus
