// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/given_sum.hpp"
#include "reference/definitions/minkowski_sum.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

/// A valid region, and a line for each thing that reading repaired: orientation, nothing else.
struct ReadRegion {
  Region region;
  std::vector<std::string> notes;
};

struct ReadSum {
  MinkowskiSum sum;
  std::vector<std::string> notes;
};

/// Reads a region in .dat, WKT (POLYGON, MULTIPOLYGON, EMPTY) or GeoJSON (Polygon, MultiPolygon),
/// told apart by the first character: a letter starts WKT, a brace GeoJSON, anything else .dat.
/// Coordinates are exact: integers, decimals (also 1.5e-3) and fractions p/q, in GeoJSON strings.
/// In .dat each component is its outer chain, the number of its holes, and the holes; a chain is
/// the number of its vertices, then x and y of each. A component that is all of the input may leave
/// out the number of holes. The number 0 alone is the empty region. `name` is what messages call
/// the text. Throws InvalidInput.
ReadRegion read_region(const std::string& text, const std::string& name);

/// Reads a sum: a region as above, or a collection (WKT GEOMETRYCOLLECTION, GeoJSON
/// GeometryCollection) of at most one region, of line strings, the dangling edges, and of points,
/// the isolated vertices. Result in canonical form. Throws InvalidInput.
ReadSum read_sum(const std::string& text, const std::string& name);

/// The same from a file; "-" is standard input. Throws InvalidInput also where it can't be opened.
ReadRegion read_region_file(const std::string& path);
ReadSum read_sum_file(const std::string& path);

/// Reads a sum from a file and checks nothing but its syntax, so that what is wrong with it can be
/// told. In the input's order, points and edges of line strings as they are. Throws InvalidInput.
GivenSum read_unchecked_sum_file(const std::string& path);

}  // namespace oplus
