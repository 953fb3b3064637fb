// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/bench/row.hpp"

namespace oplus {

/// The benchmark's rows, in the order in which they are listed. Published pairs that are not there are
/// left out.
const std::vector<Row>& benchmark_rows();

/// The published pairs of the benchmark that are not there, by name.
std::vector<std::string> missing_published_pairs();

}  // namespace oplus
