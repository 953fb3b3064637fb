// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/row.hpp"

namespace oplus {

/// The benchmark's rows, in the order in which they are listed. Published pairs that are not there are
/// left out.
const Rows& benchmark_rows();

}  // namespace oplus
