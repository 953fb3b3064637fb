// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/io/writing.hpp"

namespace oplus {

/// The format to write in: the one asked for, else by the ending of the path; WKT on standard
/// output. Throws UsageError for an ending that names no format.
Format output_format(const std::optional<Format>& asked_for, const std::string& path);

/// Throws UsageError for a picture whose path ends in something else than .svg, in capitals or not, and
/// is neither standard output nor a device.
void require_svg(const std::string& path);

/// Throws UsageError where an output could not be written or two would be written to one place, so
/// that it is known before anything is computed or written. "-" is standard output.
void require_writable(const std::vector<std::string>& paths);

}  // namespace oplus
