// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "checked/cli/batch/results.hpp"
#include "checked/operations/affine_map.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

/// A set of a file of parts.
struct Part {
  ReadSet set;
  std::string name;    ///< as JSON: its name, or its number
  std::size_t number;  ///< in the file, from one
};

/// A part that is invalid.
struct InvalidPart {
  std::size_t number;  ///< in the file, from one
  std::string error;
};

/// Reads a file of parts, one a line (docs/batch.md), and adds the invalid ones, which are left out, to
/// `invalid`. Notes in the results what was repaired. Throws InvalidInput where the file cannot be read.
std::vector<Part> read_parts(const std::string& path, Overlaps overlaps,
                             std::vector<InvalidPart>& invalid, Results& results);

/// By which angle Q is turned.
struct PartRotation {
  AffineMap map = {};
  std::string json = {};  ///< `, "degrees": "90", "cos": "0", "sin": "1"`; empty unless asked for

  ReadSet turned(ReadSet set) const;
};

/// Angles in degrees, which are multiples of 90 or else met up to `error` degrees by a rotation that takes
/// rational points to such. Throws UsageError where a text is no number, InvalidInput unless the error is positive.
std::vector<PartRotation> rotations(const std::vector<std::string>& degrees,
                                    const std::string& error);

/// The multiples of an angle in degrees that are less than 360. Throws UsageError unless it is positive and
/// there are at most 3600 of them.
std::vector<std::string> multiples_of(const std::string& degrees);

}  // namespace oplus
