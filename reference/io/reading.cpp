// SPDX-License-Identifier: MIT
#include "reference/io/reading.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "reference/definitions/validity.hpp"
#include "reference/io/invalid_region.hpp"
#include "reference/io/placed_geometry.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr const char* formats = "a region in .dat, WKT or GeoJSON";

std::string whole_text(std::istream& in, const std::string& name) {
  errno = 0;
  std::string text;
  try {
    text.assign(std::istreambuf_iterator<char>(in), {});
  } catch (const std::ios_base::failure&) {  // a directory, for one
    in.setstate(std::ios_base::badbit);
  }
  if (in.bad())
    throw InvalidInput(
        {name, 0, 0},
        "cannot be read" + (errno != 0 ? " (" + std::string(std::strerror(errno)) + ")" : ""),
        formats);
  return text;
}

InputText input_text(const std::string& text, const std::string& name) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  return {name, text.substr(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0)};
}

/// Control characters are in no text; what they would break is the terminal the message goes to.
void refuse_binary(const InputText& input) {
  Position at;
  for (const char c : input.text) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0 && !is_blank(c))
      input.refuse(at, "the byte " + quote({&c, 1}) + " is not text", formats);
    at.pass(c);
  }
}

PlacedGeometry parse(const InputText& input, Wanted wanted) {
  refuse_binary(input);
  const auto first = std::find_if_not(input.text.begin(), input.text.end(), is_blank);
  if (first == input.text.end()) input.refuse({}, "nothing but blanks or nothing at all", formats);
  if (*first == '{' || *first == '[') return parse_geojson(input, wanted);
  if (std::isalpha(static_cast<unsigned char>(*first)) != 0) return parse_wkt(input, wanted);
  return parse_dat(input);
}

/// Turns the chains that are turned the wrong way, and says so.
void orient(PlacedGeometry& geometry, const std::string& input, std::vector<std::string>& notes) {
  for (PlacedChain& chain : geometry.chains) {
    const int wanted = chain.name.hole == 0 ? 1 : -1;
    if (sign(twice_area(chain.vertices)) != -wanted) continue;
    std::reverse(std::next(chain.vertices.begin()), chain.vertices.end());
    std::reverse(std::next(chain.places.begin()), chain.places.end());
    chain.is_turned = true;
    notes.push_back(one_line(input) + ": " + describe(chain.name) + " was " +
                    (wanted > 0 ? "clockwise" : "counterclockwise") + "; turned");
  }
}

Region region_in(const PlacedGeometry& geometry) {
  Region region;
  for (const PlacedChain& chain : geometry.chains) {
    if (chain.name.hole == 0)
      region.components.push_back({chain.vertices, {}});
    else
      region.components.back().holes.push_back(chain.vertices);
  }
  return region;
}

Region valid_region(const InputText& input, PlacedGeometry& geometry,
                    std::vector<std::string>& notes) {
  orient(geometry, input.name, notes);
  Region region = region_in(geometry);
  if (const std::optional<Defect> defect = find_defect(region))
    refuse_defect(input, geometry, *defect);
  return region;
}

/// The edges of the line strings, none of zero length.
std::vector<Segment> edges_of_line_strings(const InputText& input, const PlacedGeometry& geometry) {
  std::vector<Segment> result;
  for (std::size_t l = 0; l < geometry.line_strings.size(); ++l) {
    const PlacedChain& line = geometry.line_strings[l];
    const std::string name = "line string " + std::to_string(l + 1);
    if (line.vertices.size() < 2)
      input.refuse(line.start, name + " has " + vertices(line.vertices.size()), "at least 2");
    for (std::size_t i = 1; i < line.vertices.size(); ++i) {
      if (line.vertices[i - 1] == line.vertices[i])
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
std::vector<Point> isolated_vertices(const InputText& input, const PlacedGeometry& geometry,
                                     const std::vector<Segment>& dangling) {
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
  std::sort(result.begin(), result.end());
  return result;
}

template <typename Read>
auto read_file(const std::string& path, Read read) {
  if (path == "-") return read(whole_text(std::cin, "standard input"), "standard input");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw InvalidInput({path, 0, 0}, std::string("cannot be opened (") + std::strerror(errno) + ")",
                       "a file that can be read");
  return read(whole_text(in, path), path);
}

GivenSum read_unchecked_sum(const std::string& text, const std::string& name) {
  const InputText input = input_text(text, name);
  const PlacedGeometry geometry = parse(input, Wanted::sum);
  return {region_in(geometry), edges_of_line_strings(input, geometry), geometry.points.vertices};
}

}  // namespace

ReadRegion read_region(const std::string& text, const std::string& name) {
  const InputText input = input_text(text, name);
  PlacedGeometry geometry = parse(input, Wanted::region);
  ReadRegion result;
  result.region = valid_region(input, geometry, result.notes);
  return result;
}

ReadSum read_sum(const std::string& text, const std::string& name) {
  const InputText input = input_text(text, name);
  PlacedGeometry geometry = parse(input, Wanted::sum);
  ReadSum result;
  result.sum = canonical_sum(valid_region(input, geometry, result.notes));
  result.sum.dangling_edges = maximal_segments(edges_of_line_strings(input, geometry));
  result.sum.isolated_vertices = isolated_vertices(input, geometry, result.sum.dangling_edges);
  return result;
}

ReadRegion read_region_file(const std::string& path) { return read_file(path, read_region); }

ReadSum read_sum_file(const std::string& path) { return read_file(path, read_sum); }

GivenSum read_unchecked_sum_file(const std::string& path) {
  return read_file(path, read_unchecked_sum);
}

}  // namespace oplus
