// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/io/writing.hpp"

namespace oplus {

/// Returns what write() writes, exactly.
std::string written(const Region& region, Format format);
std::string written(const MinkowskiSum& sum, Format format);

/// The same in WKT, without the end of the line.
std::string wkt(const Region& region);
std::string wkt(const MinkowskiSum& sum);

}  // namespace oplus
