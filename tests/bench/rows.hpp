// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/row.hpp"

namespace oplus {

/// The benchmark's rows, without missing published pairs.
const Rows& benchmark_rows();

}  // namespace oplus
