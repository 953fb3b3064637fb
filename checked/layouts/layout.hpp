// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/values.hpp"

namespace oplus {

/// A part where it lies.
struct PlacedPart {
  std::string name;      ///< by which its layout calls it; may be empty, or that of others
  std::size_t line = 0;  ///< of the file where it is placed
  std::shared_ptr<const Region>
      shape;  ///< valid; turned, and not yet moved; equal ones may be shared
  Vector at;  ///< by which the shape is moved
  /// A part may lie on defects of at least this quality; on none where it is empty.
  std::optional<int> least_quality = {};
};

/// A part of a container on which not every part may lie.
struct DefectiveZone {
  Region region;    ///< valid
  int quality = 0;  ///< 0: none may
};

/// Parts that share one container.
struct Sheet {
  std::string name;                 ///< for messages; empty where it is the only one
  std::optional<Region> container;  ///< valid; none: the whole plane
  std::vector<DefectiveZone> defects;
  std::vector<PlacedPart> parts;
};

/// What a file of a layout says.
struct Layout {
  std::vector<Sheet> sheets;
  std::vector<std::string>
      notes;  ///< what was turned, left out, or taken for something near by; a line each
};

}  // namespace oplus
