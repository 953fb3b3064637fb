// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace oplus {

/// Returns the text with every byte that is not printable ASCII as \xNN, so that it fits in a line.
std::string one_line(std::string_view text);

/// Returns the text as above, in quotes, shortened where it is long.
std::string quote(std::string_view text);

}  // namespace oplus
