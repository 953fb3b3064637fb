// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// A named pair with its sums. What is written where: tests/corpus/pairs.txt.
struct CorpusPair {
  std::string name;
  std::string story;
  Region p;
  Region q;
  MinkowskiSum closed;
  MinkowskiSum open;
};

/// Returns the pairs in the order of the file. Throws InvalidInput or std::runtime_error, naming the
/// row, where one is wrong.
std::vector<CorpusPair> corpus();

}  // namespace oplus
