// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/definitions/claimed_sum.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/overlaps.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

/// A valid region, and a line for each chain whose orientation was repaired and, in one, for vertices of
/// which only x and y were read. Nothing else is repaired.
struct ReadRegion {
  Region region;
  std::vector<std::string> notes;
};

struct ReadSum {
  PlanarSet sum;
  std::vector<std::string> notes;
};

/// What a closed set consists of: a valid region, and segments and points, which may cross, overlap and
/// repeat each other and the region; a segment may be a point.
struct ReadSet {
  Region region;
  std::vector<Segment> segments;
  std::vector<Point> points;
  std::vector<std::string> notes;
};

/// Which regions are taken. An unbounded one (values.hpp) is refused where all must be bounded.
enum class Extent { bounded, any };

/// Called while an input is read: for each megabyte with the percentage that is parsed, below 100,
/// and with 100 when all is parsed and the validity check starts.
using ReadingProgress = std::function<void(int percent)>;

/// Reads a region, told apart by what it starts with: WKT by a letter, GeoJSON by a brace, its coordinates
/// alone by a bracket, an SVG path by the command M or m, .dat by anything else (docs/files.md):
///  1. WKT: POLYGON, MULTIPOLYGON, a GEOMETRYCOLLECTION of these, EMPTY; several, one a line; also with
///     `SRID=4326;` before them;
///  2. GeoJSON: Polygon, MultiPolygon, a GeometryCollection of these, Feature, FeatureCollection; several likewise;
///  3. [[x, y], ...], arrays of these (the outer chain and holes), or arrays of such arrays;
///  4. SVG path data: M, L, H, V and Z, absolute or relative. A subpath inside another one that runs the
///     other way round is a hole;
///  5. WKB, whose first byte is 0 or 1, in bytes or as hexadecimal digits, then also several, one a line: Polygon
///     and MultiPolygon; an SRID is left out;
///  6. .dat.
/// All components together are one region. Vertices may have Z and M, which are left out. A ring ends with
/// its first vertex, in .dat and SVG without it, in 3 with or without. With Overlaps::allowed the
/// result is not valid where components overlap.
///
/// Coordinates are exact: integers, decimals (also 1.5e-3) and fractions p/q, in GeoJSON strings.
/// In .dat each component is its outer chain, the number of its holes, and the holes; a chain is
/// the number of its vertices, then x and y of each. A component that is all of the input may leave
/// out the number of holes. The number 0 alone is the empty region, and as the outer chain of a component
/// it makes the region unbounded. `name` is what messages call the text. Throws InvalidInput.
ReadRegion read_region(const std::string& text, const std::string& name,
                       const ReadingProgress& progress = {}, Extent extent = Extent::bounded,
                       Overlaps overlaps = Overlaps::refused);

/// The same of a text that is in this format.
ReadRegion read_region_in(Format format, const std::string& text, const std::string& name,
                          Overlaps overlaps = Overlaps::refused);

/// Turns and checks a region that was not read as a reader does; `name` is what messages call it.
/// Throws InvalidInput, without a line.
ReadRegion oriented_and_checked(Region region, const std::string& name);

/// Reads a sum: a region as above, or a collection (WKT GEOMETRYCOLLECTION, GeoJSON
/// GeometryCollection) of at most one region, of line strings, the dangling edges, and of points,
/// the isolated vertices. Result in canonical form. Throws InvalidInput.
ReadSum read_sum(const std::string& text, const std::string& name,
                 const ReadingProgress& progress = {});

/// Reads a closed set in any of these forms. Its line strings and points may be anywhere; a vertex of a line
/// string may repeat the one before it. The region may be unbounded. Throws InvalidInput.
ReadSet read_set(const std::string& text, const std::string& name,
                 const ReadingProgress& progress = {}, Overlaps overlaps = Overlaps::refused);
ReadSet read_set_file(const std::string& path, const ReadingProgress& progress = {},
                      Overlaps overlaps = Overlaps::refused);

/// The same from a file; "-" is standard input. Throws InvalidInput also where it can't be opened.
ReadRegion read_region_file(const std::string& path, const ReadingProgress& progress = {},
                            Extent extent = Extent::bounded, Overlaps overlaps = Overlaps::refused);
ReadSum read_sum_file(const std::string& path, const ReadingProgress& progress = {});

/// Reads a sum and checks only its syntax, so that its defects can be reported. In the
/// input's order, points and edges of line strings as they are. Throws InvalidInput.
ClaimedSum read_unchecked_sum(const std::string& text, const std::string& name,
                              const ReadingProgress& progress = {});
ClaimedSum read_unchecked_sum_file(const std::string& path, const ReadingProgress& progress = {});

}  // namespace oplus
