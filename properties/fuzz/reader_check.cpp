// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/reader_check.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "checked/layouts/check.hpp"
#include "checked/layouts/reading.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/input_text.hpp"
#include "reference/io/placed_geometry.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr const char* file = "input";
constexpr std::array formats{Format::dat, Format::wkt, Format::geojson};

void require_one_line(const std::string& message) {
  require(!message.empty() && std::all_of(message.begin(), message.end(),
                                          [](char c) { return c >= ' ' && c <= '~'; }),
          "a message that is not one line of printable characters: " + message);
}

void require_good_refusal(const InvalidInput& refused, std::string_view text) {
  const std::string what = refused.what();
  require_one_line(what);
  const Place& at = refused.where();
  require(what.starts_with(std::string(file) + ":" + std::to_string(at.line) + ":"),
          "a refusal that does not start with its place: " + what);
  require(what.find("; expected ") != std::string::npos,
          "a refusal that does not say what was expected: " + what);
  const std::string_view unmarked = without_byte_order_mark(text);
  // Bytes of WKB are one line, whatever they are.
  const bool is_text = !starts_as_wkb(unmarked) || unmarked[0] > 1;
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  require(at.line >= 1 && at.line <= (is_text ? lines : 1),
          "a refusal at a line that is not there: " + what);
  for (std::size_t line = 1; line < at.line; ++line) text.remove_prefix(text.find('\n') + 1);
  // At most one past the end of the line.
  require(at.column <= std::min(is_text ? text.find('\n') : text.npos, text.size()) + 1,
          "a refusal at a column that is not there: " + what);
}

ReadRegion region_from(const std::string& text) { return read_region(text, file); }
ReadSum sum_from(const std::string& text) { return read_sum(text, file); }

/// The result of `read`; nullopt where it refuses with a valid message.
template <typename Read>
auto read_or_refused(Read read, const std::string& text) -> std::optional<decltype(read(text))> {
  try {
    auto result = read(text);
    for (const std::string& note : result.notes) require_one_line(note);
    return result;
  } catch (const InvalidInput& refused) {
    require_good_refusal(refused, text);
    return std::nullopt;
  }
}

/// Law 3: `read` refuses nothing that was written, and repairs nothing.
template <typename Read>
auto read_again(Read read, const std::string& text) {
  try {
    auto result = read(text);
    require(result.notes.empty(), "what was written needed repair: " + text);
    return result;
  } catch (const InvalidInput& refused) {
    throw FuzzFinding("what was written is refused: " + std::string(refused.what()));
  }
}

void require_valid(const Region& region) {
  if (const auto defect = find_defect(region))
    throw FuzzFinding("an invalid region was read: " + describe(defect->kind));
}

/// As much as can be checked fast.
bool is_small(const Sheet& sheet) {
  std::size_t vertices = sheet.container ? vertex_count(*sheet.container) : 0;
  for (const PlacedPart& part : sheet.parts) vertices += vertex_count(*part.shape);
  for (const DefectiveZone& defect : sheet.defects) vertices += vertex_count(defect.region);
  return sheet.parts.size() <= 8 && vertices <= 60;
}

/// The parts where they lie.
Sheet as_polygons(const Sheet& sheet) {
  std::string text;
  for (const PlacedPart& part : sheet.parts)
    text += written(translated(*part.shape, part.at), Format::wkt);
  Sheet result;
  if (!text.empty()) result = read_layout(text, file, "", 1).sheets.at(0);
  return result;
}

}  // namespace

FuzzOutcome check_layout_reader(std::string_view input) {
  const std::string text(input);
  const auto layout_from = [](const std::string& layout) {
    return read_layout(layout, file, "/nowhere", Rational(1, 1000));
  };
  const std::optional<Layout> read = read_or_refused(layout_from, text);
  if (!read) return FuzzOutcome::rejected;
  for (const Sheet& sheet : read->sheets) {
    for (const PlacedPart& part : sheet.parts) require_valid(*part.shape);
    for (const DefectiveZone& defect : sheet.defects) require_valid(defect.region);
    if (sheet.container) require_valid(*sheet.container);
    if (!is_small(sheet)) continue;
    const SheetVerdict verdict = check(sheet, {Rational(1, 2), Rational(1, 3), Rational(1, 4)}, 1);
    Rational used;
    for (const PlacedPart& part : sheet.parts) used += area(*part.shape);
    require(verdict.used_area == used, "parts have another area than they use");
    Sheet bare;
    bare.parts = sheet.parts;
    std::size_t components = 0;
    for (const PlacedPart& part : sheet.parts) components += part.shape->components.size();
    if (components != sheet.parts.size()) continue;  // as polygons there are more parts
    require(check(bare, {}, 1).faults.size() == check(as_polygons(sheet), {}, 1).faults.size(),
            "as polygons where they lie, the parts have more faults or fewer");
  }
  return FuzzOutcome::reached;
}

FuzzOutcome check_region_reader(std::string_view input) {
  const std::string text(input);
  const std::optional<ReadRegion> read = read_or_refused(region_from, text);
  if (!read) return FuzzOutcome::rejected;
  const Region& region = read->region;
  require_valid(region);
  for (const Format format : formats) {
    require(read_again(region_from, written(region, format)).region == region,
            "written and read again, the region is another one");
    const auto rounded = read_or_refused(region_from, written(region, format, 2));
    if (rounded) require_valid(rounded->region);
  }
  const std::optional<ReadSum> sum = read_or_refused(sum_from, text);
  require(sum.has_value(), "a region was read that is refused as a sum");
  require(sum->sum == canonical_sum(region), "read as a sum, the region is another one");
  return FuzzOutcome::reached;
}

FuzzOutcome check_sum_reader(std::string_view input) {
  const std::string text(input);
  const std::optional<ReadSum> read = read_or_refused(sum_from, text);
  if (!read) return FuzzOutcome::rejected;
  const PlanarSet& sum = read->sum;
  const Region region = region_of(sum);
  require_valid(region);
  const PlanarSet of_region = canonical_sum(region);
  require(of_region.outer == sum.outer && of_region.holes == sum.holes,
          "a sum was read that is not in canonical form");
  require(maximal_segments(sum.dangling_edges) == sum.dangling_edges,
          "dangling edges were read that are not maximal");
  require(std::is_sorted(sum.isolated_vertices.begin(), sum.isolated_vertices.end()) &&
              std::adjacent_find(sum.isolated_vertices.begin(), sum.isolated_vertices.end()) ==
                  sum.isolated_vertices.end(),
          "isolated vertices were read that are not sorted, each once");
  for (const Format format : formats) {
    if (!can_hold(format, sum)) continue;
    require(read_again(sum_from, written(sum, format)).sum == sum,
            "written and read again, the sum is another one");
    if (const auto rounded = read_or_refused(sum_from, written(sum, format, 2)))
      require_valid(region_of(rounded->sum));
  }
  return FuzzOutcome::reached;
}

}  // namespace oplus
