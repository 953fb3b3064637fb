// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace oplus {

/// Returns "1 segment", "2 segments".
inline std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace oplus
