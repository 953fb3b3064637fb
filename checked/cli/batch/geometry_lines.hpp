// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/io/reading.hpp"

namespace oplus {

/// A line of an input.
struct PlacedLine {
  const std::string& file;  ///< what messages call the input
  std::size_t number;       ///< from one
  std::string_view text;    ///< without the end of the line
};

/// Whether there is nothing to compute in a line: it is blank, or starts with #.
bool is_blank_or_comment(std::string_view line);

/// What is done with an id, in JSON.
using TakeId = std::function<void(std::string_view)>;

/// Two summands: bounded sets.
struct PairLine {
  ReadSet p;
  ReadSet q;
  std::vector<std::string> notes;  ///< what reading repaired
};

/// Reads two geometries with a tab between them, each in any form that read_set takes, or a JSON object
/// {"p": ..., "q": ...} of GeoJSON geometries or of strings in these forms. It may have an "id" of any type,
/// which is passed on as in the line, before the geometries are looked at. Where components may overlap, the
/// regions are their unions. Throws InvalidInput, which names the file, the line and the column.
PairLine read_pair_line(const PlacedLine& line, Overlaps overlaps, const TakeId& take_id);

struct PartLine {
  ReadSet set;
  std::string name;  ///< empty where there is none
  std::vector<std::string> notes;
};

/// Reads one geometry, with its name and a tab before it, or without. Throws as read_pair_line does.
PartLine read_part_line(const PlacedLine& line, Overlaps overlaps);

}  // namespace oplus
