// SPDX-License-Identifier: MIT
#include "reference/io/reading.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "reference/chains/frame.hpp"
#include "reference/chains/near_point.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/invalid_region.hpp"
#include "reference/io/placed_geometry.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/unchecked_input.hpp"

namespace oplus {

namespace {

constexpr const char* formats =
    "a region in .dat, WKT, WKB or GeoJSON, an array, or the data of an SVG path";

/// Control characters are invalid in text, and in a message they would confuse the terminal.
void refuse_binary(const InputText& input) {
  const auto is_control = [](char c) {
    return (static_cast<unsigned char>(c) < ' ' && !is_blank(c)) || c == '\x7f';
  };
  const auto found = std::find_if(input.text.begin(), input.text.end(), is_control);
  if (found == input.text.end()) return;
  Position at;
  std::for_each(input.text.begin(), found, [&](char c) { at.pass(c); });
  input.refuse(at, "the byte " + quote({&*found, 1}) + " is not text", formats);
}

/// What was parsed, and the name of the input. Without its text, whose memory is free by now.
struct Parsed {
  InputText input;
  PlacedGeometry geometry;
};

PlacedGeometry parse(const InputText& input, Format format, Wanted wanted) {
  switch (format) {
    case Format::wkt:
      return parse_wkt(input, wanted);
    case Format::geojson:
      return parse_geojson(input, wanted);
    case Format::wkb:
      return parse_wkb(input, wanted);
    case Format::dat:
      break;
  }
  return parse_dat(input);
}

/// In the format that the first character that is not blank tells, and of an SVG path the second.
PlacedGeometry parse(const InputText& input, Wanted wanted, Overlaps overlaps) {
  const auto first = std::find_if_not(input.text.begin(), input.text.end(), is_blank);
  if (first == input.text.end()) input.refuse({}, "the input is empty", formats);
  if (is_svg_path(input.text)) return parse_svg_path(input, overlaps);
  if (*first == '<') {
    Position at;
    std::for_each(input.text.begin(), first, [&](char c) { at.pass(c); });
    input.refuse(at, "markup, such as an SVG file's",
                 "of an SVG file the data of a path alone, what its attribute d has");
  }
  if (*first == '{' || *first == '[') return parse_geojson(input, wanted);
  const bool is_letter = std::isalpha(static_cast<unsigned char>(*first)) != 0;
  return is_letter ? parse_wkt(input, wanted) : parse_dat(input);
}

Parsed parsed(std::string_view text, const std::string& name, Wanted wanted, Overlaps overlaps,
              const ReadingProgress& progress, std::optional<Format> format = std::nullopt) {
  text = without_byte_order_mark(text);
  const InputText input{name, text, progress};
  if (!format && starts_as_wkb(text)) format = Format::wkb;
  if (format != Format::wkb) refuse_binary(input);
  Parsed result{{name}, format ? parse(input, *format, wanted) : parse(input, wanted, overlaps)};
  if (progress) progress(100);
  return result;
}

Parsed parsed_file(const std::string& path, Wanted wanted, Overlaps overlaps,
                   const ReadingProgress& progress) {
  return parsed(input_text(path, formats), input_name(path), wanted, overlaps, progress);
}

/// Adds a note where coordinates were left out.
void note_what_was_left_out(const Parsed& parsed, std::vector<std::string>& notes) {
  const std::size_t count = parsed.geometry.beyond_the_plane;
  if (count == 0) return;
  notes.push_back(one_line(parsed.input.name) + ": of " + vertices(count) +
                  " with more than two coordinates, only x and y were read");
}

/// Reverses the chains with the wrong orientation; adds a note for each.
void orient(PlacedGeometry& geometry, const std::string& input, std::vector<std::string>& notes) {
  for (PlacedChain& chain : geometry.chains)
    if (turn_as_named(chain))
      notes.push_back(one_line(input) + ": " + describe(chain.name) + " was " +
                      (chain.name.hole == 0 ? "clockwise" : "counterclockwise") + "; turned");
}

/// A defect of the region or, where components may overlap, of one of its components.
std::optional<Defect> defect_of(Region& region, Overlaps overlaps) {
  const auto defect_in = [](const Region& r) {
    return is_unbounded(r) ? find_defect(framed(r, 1)) : find_defect(r);
  };
  if (overlaps == Overlaps::refused) return defect_in(region);
  std::size_t chains = 0;
  for (Component& component : region.components) {
    Region alone;
    alone.components.push_back(std::move(component));
    std::optional<Defect> defect = defect_in(alone);
    component = std::move(alone.components[0]);
    if (defect) {
      defect->first.chain += chains;
      defect->second.chain += chains;
      return defect;
    }
    chains += 1 + component.holes.size();
  }
  return std::nullopt;
}

/// Throws InvalidInput where an outer chain is missing that must not be.
void require_outer_chains(const Parsed& parsed, Extent extent) {
  const PlacedChain* missing = nullptr;
  for (const PlacedChain& chain : parsed.geometry.chains) {
    if (!chain.vertices.empty()) continue;
    if (extent == Extent::bounded)
      parsed.input.refuse(chain.start,
                          describe(chain.name) + " is missing, so the region is unbounded",
                          "a bounded region");
    if (missing != nullptr)
      parsed.input.refuse(
          chain.start,
          describe(chain.name) + " is missing, and so is the " + describe(missing->name),
          "at most one component without an outer chain");
    missing = &chain;
  }
}

Region valid_region(Parsed& parsed, std::vector<std::string>& notes, Extent extent,
                    Overlaps overlaps = Overlaps::refused) {
  require_outer_chains(parsed, extent);
  require_closed_rings(parsed.input, parsed.geometry);
  note_what_was_left_out(parsed, notes);
  orient(parsed.geometry, parsed.input.name, notes);
  Region region = take_region(parsed.geometry);
  const std::optional<Defect> defect = defect_of(region, overlaps);
  if (defect && !OPLUS_MUTANT("regions-are-read-unseen", "regions are not validated when read")) {
    exchange_vertices(parsed.geometry, region);
    refuse_defect(parsed.input, parsed.geometry, *defect);
  }
  return region;
}

/// The edges of the line strings. Throws InvalidInput where one has zero length, unless that is allowed.
std::vector<Segment> edges_of_line_strings(const Parsed& parsed, bool may_repeat_vertices = false) {
  const auto& [input, geometry] = parsed;
  std::vector<Segment> result;
  for (std::size_t l = 0; l < geometry.line_strings.size(); ++l) {
    const PlacedChain& line = geometry.line_strings[l];
    const std::string name = "line string " + std::to_string(l + 1);
    if (line.vertices.size() < 2)
      input.refuse(line.start, name + " has " + vertices(line.vertices.size()), "at least 2");
    for (std::size_t i = 1; i < line.vertices.size(); ++i) {
      if (line.vertices[i - 1] == line.vertices[i] && !may_repeat_vertices)
        input.refuse(line.places[i],
                     name + " has an edge of zero length: vertices " + std::to_string(i) + " and " +
                         std::to_string(i + 1) + " are both " + to_string(line.vertices[i]),
                     "consecutive vertices to differ");
      result.push_back({line.vertices[i - 1], line.vertices[i]});
    }
  }
  return result;
}

/// The points, each isolated from the other points and from the dangling edges.
std::vector<Point> isolated_vertices(const Parsed& parsed, const std::vector<Segment>& dangling) {
  const auto& [input, geometry] = parsed;
  const PlacedChain& points = geometry.points;
  std::map<Point, std::size_t> seen;
  for (std::size_t i = 0; i < points.vertices.size(); ++i) {
    const Point& p = points.vertices[i];
    const std::string name = "point " + std::to_string(i + 1) + ", " + to_string(p) + ",";
    const auto [first, is_new] = seen.emplace(p, i);
    if (!is_new)
      input.refuse(points.places[i], name + " is also point " + std::to_string(first->second + 1),
                   "each isolated vertex once");
    for (const Segment& e : dangling) {
      if (lies_on(p, e))
        input.refuse(points.places[i],
                     name + " lies on the dangling edge from " + to_string(e.source) + " to " +
                         to_string(e.target),
                     "an isolated vertex");
    }
  }
  std::vector<Point> result = points.vertices;
  if (!OPLUS_MUTANT("points-stay-in-any-order",
                    "the isolated vertices of a sum are not sorted when read"))
    std::sort(result.begin(), result.end());
  return result;
}

ReadRegion read_region(Parsed parsed, Extent extent, Overlaps overlaps = Overlaps::refused) {
  ReadRegion result;
  result.region = valid_region(parsed, result.notes, extent, overlaps);
  return result;
}

ReadSum read_sum(Parsed parsed) {
  ReadSum result;
  result.sum = canonical_sum(valid_region(parsed, result.notes, Extent::bounded));
  result.sum.dangling_edges = maximal_segments(edges_of_line_strings(parsed));
  result.sum.isolated_vertices = isolated_vertices(parsed, result.sum.dangling_edges);
  return result;
}

ReadSet read_set(Parsed parsed, Overlaps overlaps) {
  ReadSet result;
  result.region = valid_region(parsed, result.notes, Extent::any, overlaps);
  result.segments = edges_of_line_strings(parsed, true);
  result.points = std::move(parsed.geometry.points.vertices);
  return result;
}

UncheckedInput unchecked(Parsed parsed) {
  UncheckedInput result;
  note_what_was_left_out(parsed, result.notes);
  result.name = std::move(parsed.input.name);
  result.geometry = std::move(parsed.geometry);
  return result;
}

ClaimedSum unchecked_sum(Parsed parsed) {
  require_outer_chains(parsed, Extent::bounded);
  require_closed_rings(parsed.input, parsed.geometry);
  std::vector<Segment> dangling = edges_of_line_strings(parsed);
  return {take_region(parsed.geometry), std::move(dangling),
          std::move(parsed.geometry.points.vertices)};
}

}  // namespace

void exchange_vertices(PlacedGeometry& geometry, Region& region) {
  auto placed = geometry.chains.begin();
  for (Component& component : region.components) {
    component.outer.swap(placed++->vertices);
    for (Chain& hole : component.holes) hole.swap(placed++->vertices);
  }
}

Region take_region(PlacedGeometry& geometry) {
  Region region;
  for (const PlacedChain& chain : geometry.chains) {
    if (chain.name.hole == 0)
      region.components.emplace_back();
    else
      region.components.back().holes.emplace_back();
  }
  exchange_vertices(geometry, region);
  return region;
}

bool turn_as_named(PlacedChain& chain) {
  if (sign_of_area(chain.vertices) != (chain.name.hole == 0 ? -1 : 1)) return false;
  std::reverse(std::next(chain.vertices.begin()), chain.vertices.end());
  std::reverse(std::next(chain.places.begin()), chain.places.end());
  if (!chain.numbers.empty()) std::reverse(std::next(chain.numbers.begin()), chain.numbers.end());
  chain.is_turned = !chain.is_turned;
  return true;
}

ReadRegion read_region(const std::string& text, const std::string& name,
                       const ReadingProgress& progress, Extent extent, Overlaps overlaps) {
  return read_region(parsed(text, name, Wanted::region, overlaps, progress), extent, overlaps);
}

ReadRegion read_region_in(Format format, const std::string& text, const std::string& name,
                          Overlaps overlaps) {
  return read_region(parsed(text, name, Wanted::region, overlaps, {}, format), Extent::any,
                     overlaps);
}

ReadRegion oriented_and_checked(Region region, const std::string& name) {
  UncheckedInput input = unchecked(std::move(region), name);
  for (const PlacedChain& chain : input.geometry.chains)
    if (chain.vertices.size() < 3)
      refuse_too_few_vertices({name}, chain.start, chain.name, chain.vertices.size());
  return checked_region(std::move(input));
}

ReadRegion checked_region(UncheckedInput input) {
  return read_region(Parsed{{std::move(input.name)}, std::move(input.geometry)}, Extent::bounded);
}

UncheckedInput unchecked(Region region, const std::string& name) {
  constexpr Position nowhere{0, 0};
  Parsed parsed{{name}, {}};
  PlacedGeometry& geometry = parsed.geometry;
  const auto add = [&](const ChainName& chain_name, Chain& chain) {
    const std::size_t length = chain.size();
    geometry.chains.push_back({.name = chain_name,
                               .vertices = std::move(chain),
                               .places = std::vector<Position>(length, nowhere),
                               .start = nowhere});
  };
  for (Component& component : region.components) {
    const std::size_t number = geometry.next_component();
    add({number, 0}, component.outer);
    for (std::size_t h = 0; h < component.holes.size(); ++h)
      add({number, h + 1}, component.holes[h]);
  }
  return unchecked(std::move(parsed));
}

ReadSum read_sum(const std::string& text, const std::string& name,
                 const ReadingProgress& progress) {
  return read_sum(parsed(text, name, Wanted::sum, Overlaps::refused, progress));
}

ReadSet read_set(const std::string& text, const std::string& name, const ReadingProgress& progress,
                 Overlaps overlaps) {
  return read_set(parsed(text, name, Wanted::sum, overlaps, progress), overlaps);
}

ReadSet read_set_file(const std::string& path, const ReadingProgress& progress, Overlaps overlaps) {
  return read_set(parsed_file(path, Wanted::sum, overlaps, progress), overlaps);
}

ReadRegion read_region_file(const std::string& path, const ReadingProgress& progress, Extent extent,
                            Overlaps overlaps) {
  return read_region(parsed_file(path, Wanted::region, overlaps, progress), extent, overlaps);
}

UncheckedInput read_unchecked(const std::string& text, const std::string& name,
                              const ReadingProgress& progress) {
  return unchecked(parsed(text, name, Wanted::region, Overlaps::allowed, progress));
}

UncheckedInput read_unchecked_file(const std::string& path, const ReadingProgress& progress) {
  return unchecked(parsed_file(path, Wanted::region, Overlaps::allowed, progress));
}

ReadSum read_sum_file(const std::string& path, const ReadingProgress& progress) {
  return read_sum(parsed_file(path, Wanted::sum, Overlaps::refused, progress));
}

ClaimedSum read_unchecked_sum(const std::string& text, const std::string& name,
                              const ReadingProgress& progress) {
  return unchecked_sum(parsed(text, name, Wanted::sum, Overlaps::allowed, progress));
}

ClaimedSum read_unchecked_sum_file(const std::string& path, const ReadingProgress& progress) {
  return unchecked_sum(parsed_file(path, Wanted::sum, Overlaps::allowed, progress));
}

}  // namespace oplus
