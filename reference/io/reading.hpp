// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/definitions/given_sum.hpp"
#include "reference/definitions/minkowski_sum.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

/// A valid region, and a line for each chain whose orientation was repaired. Nothing else is repaired.
struct ReadRegion {
  Region region;
  std::vector<std::string> notes;
};

struct ReadSum {
  MinkowskiSum sum;
  std::vector<std::string> notes;
};

/// Called while an input is read: for each megabyte with the percentage that is parsed, below 100,
/// and with 100 when all is parsed and the validity check starts.
using ReadingProgress = std::function<void(int percent)>;

/// Reads a region in .dat, WKT (POLYGON, MULTIPOLYGON, EMPTY) or GeoJSON (Polygon, MultiPolygon),
/// told apart by the first character: a letter starts WKT, a brace GeoJSON, anything else .dat.
/// Coordinates are exact: integers, decimals (also 1.5e-3) and fractions p/q, in GeoJSON strings.
/// In .dat each component is its outer chain, the number of its holes, and the holes; a chain is
/// the number of its vertices, then x and y of each. A component that is all of the input may leave
/// out the number of holes. The number 0 alone is the empty region. `name` is what messages call
/// the text. Throws InvalidInput.
ReadRegion read_region(const std::string& text, const std::string& name,
                       const ReadingProgress& progress = {});

/// The same of a text that is in this format.
ReadRegion read_region_in(Format format, const std::string& text, const std::string& name);

/// Turns and checks a region that was not read as a reader does; `name` is what messages call it.
/// Throws InvalidInput, without a line.
ReadRegion oriented_and_checked(Region region, const std::string& name);

/// Reads a sum: a region as above, or a collection (WKT GEOMETRYCOLLECTION, GeoJSON
/// GeometryCollection) of at most one region, of line strings, the dangling edges, and of points,
/// the isolated vertices. Result in canonical form. Throws InvalidInput.
ReadSum read_sum(const std::string& text, const std::string& name,
                 const ReadingProgress& progress = {});

/// The same from a file; "-" is standard input. Throws InvalidInput also where it can't be opened.
ReadRegion read_region_file(const std::string& path, const ReadingProgress& progress = {});
ReadSum read_sum_file(const std::string& path, const ReadingProgress& progress = {});

/// Reads a sum from a file and checks only its syntax, so that its defects can be reported. In the
/// input's order, points and edges of line strings as they are. Throws InvalidInput.
GivenSum read_unchecked_sum_file(const std::string& path, const ReadingProgress& progress = {});

}  // namespace oplus
