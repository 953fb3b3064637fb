// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "properties/compare/task.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

/// The pair in two files. Throws InvalidInput.
Task pair_of_files(const std::filesystem::path& p, const std::filesystem::path& q,
                   Extent extent = Extent::bounded);

/// All pairs in a folder: files NAME_part1 and NAME_part2 are a pair; the others are paired with
/// each other and with themselves. Files other than .dat, .wkt, .json and .geojson are left out.
/// Throws InvalidInput.
std::vector<Task> pairs_of_folder(const std::filesystem::path& folder);

/// The part "files".
TaskSource given_source(std::vector<Task> tasks);

/// The pair that `oplus gen` makes of a family. Requires: n >= family.smallest.
Task generated_pair(const Family& family, std::size_t n, std::uint64_t seed);

/// Generated pairs, the part "families". Task i has its own seed, derived from `seed` and i, and a size
/// between the family's smallest and `largest`, by default its typical size.
TaskSource family_source(const Family& family, std::size_t count, std::uint64_t seed,
                         std::optional<std::size_t> largest);

/// Pairs of grid polygons (grid_polygons.hpp), the part "grids": all of them, or an even selection of
/// `most_pairs`.
TaskSource grid_source(int side, std::size_t most_vertices,
                       std::size_t most_pairs = static_cast<std::size_t>(-1));

/// The part "parts": the no-fit polygons P ⊕ −Q of a file of parts, one a line; each with itself, too. Throws
/// InvalidInput.
TaskSource parts_source(const std::filesystem::path& file);

/// The part "corpus": its pairs, each both ways round.
std::vector<TaskSource> corpus_sources();

}  // namespace oplus
