// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "reference/io/reading.hpp"
#include "tests/reference/definitions/shapes.hpp"
#include "tests/reference/io/refusal.hpp"

namespace oplus {

inline ReadRegion region_from(const std::string& text) { return read_region(text, "file"); }

inline ReadSum sum_from(const std::string& text) { return read_sum(text, "file"); }

}  // namespace oplus
