// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/families/family.hpp"

namespace oplus {

/// What a row is for.
enum class Subject {
  sums,        ///< every engine of sums
  growth,      ///< slide alone, as the convolution grows
  convolution  ///< cycle tracing and the naive way to the convolution
};

/// The same input for several engines.
struct BenchRow {
  std::string name;
  std::string group;  ///< rows of one group are neighbours
  std::string what;
  Subject subject;
  std::size_t pairs;
  std::function<std::vector<Summands>()> make;  ///< the same each time
};

/// All rows, in the order in which they are listed. Published pairs that are not there are left out.
const std::vector<BenchRow>& rows();

/// Returns nullptr for an unknown name.
const BenchRow* find_row(const std::string& name);

/// Whether an engine is for this row.
bool is_for(const std::string& engine, const BenchRow& row);

/// The published pairs that are not there, by name.
std::vector<std::string> missing_published_pairs();

}  // namespace oplus
