// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/parts.hpp"

#include <optional>
#include <utility>

#include "checked/cli/batch/computation.hpp"
#include "checked/cli/batch/geometry_lines.hpp"
#include "checked/cli/batch/line_batches.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/operations/image.hpp"
#include "checked/oplus/oplus.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

std::vector<Part> read_parts(const std::string& path, Overlaps overlaps,
                             std::vector<InvalidPart>& invalid, Results& results) {
  std::vector<Part> parts;
  LineBatches batches(path);
  std::size_t count = 0;
  while (const std::optional<LineBatch> batch = batches.next())
    each_line(*batch, [&](std::string_view text, std::size_t number) {
      if (is_blank_or_comment(text)) return;
      ++count;
      try {
        PartLine part = read_part_line({batches.name(), number, text}, overlaps);
        results.note(batches.name(), number, part.notes);
        parts.push_back({std::move(part.set),
                         part.name.empty() ? std::to_string(count) : in_json(part.name), count});
      } catch (const InvalidInput& error) {
        invalid.push_back({count, error.what()});
      }
    });
  return parts;
}

ReadSet PartRotation::turned(ReadSet set) const {
  if (map == AffineMap{}) return set;
  ReadSet result{image(map, set.region), {}, {}, {}};
  for (const Segment& s : set.segments) result.segments.push_back({map(s.source), map(s.target)});
  for (const Point& p : set.points) result.points.push_back(map(p));
  return result;
}

std::vector<PartRotation> rotations(const std::vector<std::string>& degrees,
                                    const std::string& error) {
  const Rational largest = angle_error(error);
  std::vector<PartRotation> result;
  for (const std::string& text : degrees) {
    const Rational angle = number("--rotations", text);
    const AffineMap map = rotation(angle, largest);
    result.push_back({map, ", \"degrees\": \"" + to_string(angle) + "\", \"cos\": \"" +
                               to_string(map.a) + "\", \"sin\": \"" + to_string(map.c) + '"'});
  }
  return result;
}

std::vector<std::string> multiples_of(const std::string& degrees) {
  constexpr int most = 3600;
  const Rational step = number("--rotation-step", degrees);
  if (step <= 0 || step * most < 360)
    throw UsageError("--rotation-step must be at least a tenth of a degree, not " + degrees);
  std::vector<std::string> result;
  for (Rational angle = 0; angle < 360; angle += step) result.push_back(to_string(angle));
  return result;
}

}  // namespace oplus
