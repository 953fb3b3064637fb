// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/values.hpp"

namespace oplus::certificates {

/// The text of what shows a program that is proved to be right that no two parts have an inner point in common and
/// that each part is inside the container: convex pieces of the parts, and of what is outside of the container, between
/// which the program finds lines (docs/certificates.md). That it is so is not seen here. Requires: all are valid and
/// bounded. Throws InvalidInput where the text would be larger than what oplus-certified reads.
std::string layout_certificate(const std::optional<Region>& container,
                               const std::vector<Region>& parts);

}  // namespace oplus::certificates
