// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

enum class Format { dat, wkt, geojson, wkb };

/// Returns the format by the path's ending, .dat, .wkt, .wkb, .json or .geojson; nothing for any other.
std::optional<Format> format_of(const std::string& path);

/// More decimals are not written: they would fill the memory with zeros.
inline constexpr int most_digits = 4096;

/// Returns the exact decimal where it ends, else p/q. With `digits`: rounded to that many decimals,
/// half away from zero, without zeros at the end.
/// Requires: 0 <= digits <= most_digits.
std::string to_string(const Rational& value, std::optional<int> digits = std::nullopt);

/// Returns "(x, y)", exactly.
std::string to_string(const Point& p);

/// Whether a format can hold the sum: .dat has no form for dangling edges and isolated vertices, the others
/// have none for what is unbounded.
bool can_hold(Format format, const PlanarSet& sum);

/// A coordinate that is not exactly a double; empty where there is none, so that WKB can hold them all.
std::optional<Rational> not_a_double(const Region& region, const PlanarSet& features);

/// Returns the text of a value, exactly; with `digits`, rounded, which WKT and GeoJSON readers may
/// find invalid. In GeoJSON a number that is no finite decimal, or has thousands of digits, is a
/// string. A sum is written as region_of(sum), so that each ring is simple, its dangling edges as
/// line strings and its isolated vertices as points. WKB is written in hexadecimal digits, never rounded.
/// Requires: can_hold(format, sum); for WKB, that not_a_double returns none.
std::string written(const Region& region, Format format, std::optional<int> digits = std::nullopt);
std::string written(const PlanarSet& sum, Format format, std::optional<int> digits = std::nullopt);

/// The same of a sum whose region is known. Requires also: region == region_of(sum).
std::string written(const PlanarSet& sum, const Region& region, Format format,
                    std::optional<int> digits = std::nullopt);

/// The same in WKT, exactly, without the end of the line.
std::string wkt(const Region& region);
std::string wkt(const PlanarSet& sum);

/// Writes a file as a whole or not at all: to a temporary one beside it, then renamed. "-" is
/// standard output. A device or another special file is written to, not replaced.
/// Throws std::system_error.
void write_file(const std::string& path, const std::string& content);

}  // namespace oplus
