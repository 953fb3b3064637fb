// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "reference/definitions/region.hpp"
#include "reference/io/input_text.hpp"
#include "reference/io/json_tree.hpp"
#include "reference/io/number.hpp"
#include "reference/io/overlaps.hpp"

namespace oplus {

/// How messages name a chain; both from one, hole 0 being the outer chain.
struct ChainName {
  std::size_t component = 1;
  std::size_t hole = 0;
};

/// Returns "outer chain of component 1" or "hole 2 of component 1".
std::string describe(const ChainName& name);

/// Vertices and their places in the input, where defects of the chain are reported.
struct PlacedChain {
  ChainName name = {};  ///< of a region's chain
  Chain vertices = {};
  std::vector<Position> places = {};  ///< of each vertex; a missing outer chain has one
  Position start = {};
  bool is_turned = false;  ///< whether the vertices after the first are in reverse order
  bool is_open = false;    ///< whether it is a ring whose last vertex is not the first one again
  std::vector<std::size_t> numbers = {};  ///< of each vertex in the input; empty: from one

  /// Makes room for `count` vertices, or for as many as fit in the bytes that follow: the count may
  /// be wrong.
  void reserve(std::size_t count, std::size_t bytes) {
    constexpr std::size_t bytes_of_a_vertex = 4;  // "0 0,"
    count = std::min(count, bytes / bytes_of_a_vertex + 1);
    vertices.reserve(count);
    places.reserve(count);
  }
};

/// The content of an input, in its order, of which only the syntax was checked. Rings are without the
/// closing vertex, but for open ones.
struct PlacedGeometry {
  std::vector<PlacedChain> chains;  ///< as chains(region) has them
  std::vector<PlacedChain> line_strings;
  PlacedChain points;
  std::size_t beyond_the_plane =
      0;  ///< vertices with more coordinates than x and y, which alone were kept
  bool has_directions = false;  ///< whether the input gives each chain a direction, and no role

  /// The number that the next component gets.
  std::size_t next_component() const {
    return chains.empty() ? 1 : chains.back().name.component + 1;
  }
};

/// What is to be read: line strings and points are for sums only.
enum class Wanted { region, sum };

/// Returns "x of vertex 3 of hole 2 of component 1".
std::string coordinate_name(char axis, std::size_t vertex, const std::string& chain);

/// Returns "3 vertices", "1 vertex".
std::string vertices(std::size_t count);

/// Puts the coordinate that the text at a place denotes into `value`. `name()` is what messages call it.
/// Throws InvalidInput.
template <typename Name>
void put_coordinate(const InputText& input, std::string_view text, const Position& at,
                    Rational& value, Name name) {
  NumberFault fault;
  if (!put_number(text, value, fault))
    input.refuse(at, name() + ": " + fault.wrong, fault.expected);
}

/// Removes the last vertex of a ring where it is the first one again; else the ring is open. A ring of one
/// vertex or none stays as it is.
void remove_closing_vertex(PlacedChain& ring);

/// Throws InvalidInput where a ring is open.
void require_closed_rings(const InputText& input, const PlacedGeometry& geometry);

/// Throws InvalidInput: a chain needs more vertices than these.
[[noreturn]] void refuse_too_few_vertices(const InputText& input, const Position& at,
                                          const ChainName& name, std::size_t count);

/// "1 coordinate" where others of the same geometry have more or fewer. Throws InvalidInput.
[[noreturn]] void refuse_dimension(const InputText& input, const Position& at,
                                   const std::string& vertex, std::size_t dimension,
                                   std::size_t of_others);

/// The formats. Each throws InvalidInput where the syntax is wrong.
PlacedGeometry parse_dat(const InputText& input);
PlacedGeometry parse_wkt(const InputText& input, Wanted wanted);
PlacedGeometry parse_geojson(const InputText& input, Wanted wanted);
/// A value of the text: a GeoJSON geometry, or coordinates alone.
PlacedGeometry parse_geojson(const InputText& input, JsonValue value);
PlacedGeometry parse_wkb(const InputText& input, Wanted wanted);
PlacedGeometry parse_svg_path(const InputText& input, Overlaps overlaps);

/// Whether a text is to be read as an SVG path: it starts with the command M or m, and not with a word.
bool is_svg_path(std::string_view text);

/// Whether a text starts as well-known binary does, in bytes or in hexadecimal digits.
bool starts_as_wkb(std::string_view text);

}  // namespace oplus
