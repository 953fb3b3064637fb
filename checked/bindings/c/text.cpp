// SPDX-License-Identifier: MIT
// Sets as text.
#include <optional>
#include <string>
#include <vector>

#include "checked/bindings/c/set.hpp"
#include "checked/version.hpp"
#include "reference/io/reading.hpp"

namespace {

using namespace oplus;

std::optional<int> rounded_to(int digits) { return digits < 0 ? std::optional<int>() : digits; }

/// A line: the kind, and the coordinates of the vertices.
std::string line_of(int kind, const Chain& chain) {
  std::string line = std::to_string(kind);
  for (const Point& vertex : chain) c::append(line, vertex);
  return line + "\n";
}

std::string lines_of(const Region& region, const std::vector<Segment>& segments,
                     const std::vector<Point>& points) {
  std::string all;
  for (const auto& [outer, holes] : region.components) {
    all += line_of(OPLUS_OUTER, outer);
    for (const Chain& hole : holes) all += line_of(OPLUS_HOLE, hole);
  }
  for (const auto& [source, target] : segments) all += line_of(OPLUS_LINE, {source, target});
  for (const Point& point : points) all += line_of(OPLUS_POINT, {point});
  return all;
}

}  // namespace

const char* oplus_version() { return version; }

oplus_code oplus_read(const char* text, oplus_set** set) {
  return c::put(set, [&] { return ValidSet(read_text(&c::given(text, "text"))); });
}

oplus_code oplus_read_set(const char* text, oplus_set** set) {
  return c::put(set, [&] { return read_set(&c::given(text, "text")); });
}

oplus_code oplus_as_written(const char* text, char** chains, char** notes, char** fault) {
  return c::code_of([&] {
    char** const to[] = {&c::given(chains, "chains"), &c::given(notes, "notes"),
                         &c::given(fault, "fault")};
    const std::string given = &c::given(text, "text");
    std::string lines, noted, wrong;
    try {
      const ReadSet set = read_set(given, "text");
      lines = lines_of(set.region, set.segments, set.points);
      for (const std::string& note : set.notes) noted += note + "\n";
    } catch (const InvalidInput& invalid) {
      const ClaimedSum as_it_is = read_claimed_sum(given);
      lines = lines_of(as_it_is.region, as_it_is.dangling_edges, as_it_is.isolated_vertices);
      wrong = invalid.what();
    }
    *to[0] = c::copied(lines);
    *to[1] = c::copied(noted);
    *to[2] = c::copied(wrong);
  });
}

oplus_code oplus_wkt(const oplus_set* set, int digits, char** text) {
  return c::put(text, [&] { return to_wkt(c::set(set, "set"), rounded_to(digits)); });
}

oplus_code oplus_geojson(const oplus_set* set, int digits, char** text) {
  return c::put(text, [&] { return to_geojson(c::set(set, "set"), rounded_to(digits)); });
}

void oplus_free(oplus_set* set) { delete set; }
