// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// A named pair with its sums. What is written where: tests/corpus/pairs.txt.
struct Row {
  std::string name;
  std::string story;
  Region p;
  Region q;
  MinkowskiSum closed;
  MinkowskiSum open;
};

/// Returns the rows in the order of the file. Throws InvalidInput or std::runtime_error, naming the
/// row, where one is wrong.
std::vector<Row> corpus();

}  // namespace oplus
