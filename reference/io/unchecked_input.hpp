// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/io/placed_geometry.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

/// A region as it was written down, of which only the syntax was checked.
struct UncheckedInput {
  std::string name;  ///< what messages call it
  PlacedGeometry geometry;
  std::vector<std::string> notes;  ///< what was left out
};

/// Reads what read_region and read_region_file read, and also open rings. Throw InvalidInput where the
/// syntax is wrong.
UncheckedInput read_unchecked(const std::string& text, const std::string& name,
                              const ReadingProgress& progress = {});
UncheckedInput read_unchecked_file(const std::string& path, const ReadingProgress& progress = {});

/// Turns and checks it as a reader does. Throws InvalidInput where the region is not valid.
ReadRegion checked_region(UncheckedInput input);

/// A region from code in the same form, with no place anywhere.
UncheckedInput unchecked(Region region, const std::string& name);

/// The region of the chains, which are without vertices afterwards.
Region take_region(PlacedGeometry& geometry);

/// Exchanges the vertices of the chains with those of a region of as many chains.
void exchange_vertices(PlacedGeometry& geometry, Region& region);

/// Reverses a chain behind its first vertex where it runs the wrong way for an outer chain, or for a hole;
/// returns whether it did.
bool turn_as_named(PlacedChain& chain);

}  // namespace oplus
