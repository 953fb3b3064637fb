// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "properties/compare/differential.hpp"

namespace oplus {

/// How many cases of a family the main job runs.
std::size_t main_job_cases(const std::string& family);

/// The pair in two files. Reads them at once. Throws InvalidInput.
DifferentialCase case_of_files(const std::filesystem::path& p, const std::filesystem::path& q);

/// All pairs in a folder: files NAME_part1 and NAME_part2 are a pair; the others are paired with
/// each other and with themselves. Files that are not .dat, .wkt, .json or .geojson are left out.
/// Throws InvalidInput.
std::vector<DifferentialCase> cases_of_folder(const std::filesystem::path& folder);

/// Generated pairs. Case i has its own seed, derived from `seed` and i, and a size between the
/// family's smallest and `largest`, by default its typical size.
std::vector<DifferentialCase> cases_of_family(const Family& family, std::size_t count,
                                              std::uint64_t seed,
                                              std::optional<std::size_t> largest);

}  // namespace oplus
