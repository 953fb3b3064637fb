// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "reference/families/family.hpp"

namespace oplus {

/// A row of the thesis's Table 6.1: a pair that was published, and what was measured then.
struct PublishedPair {
  std::string name;  ///< of the files NAME_part1.dat and NAME_part2.dat
  double t_w;        ///< seconds
  double t_rc;
  std::size_t a_w;  ///< edges of the arrangement
  std::size_t a_rc;
};

/// All rows, in the thesis's order.
const std::vector<PublishedPair>& published_pairs();

/// The folder in which they are looked for; where it or a pair is missing, that is said and counted.
std::filesystem::path published_folder();

bool is_there(const PublishedPair& pair);

/// Throws InvalidInput.
Summands read(const PublishedPair& pair);

}  // namespace oplus
