// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// That of CMakeLists.txt; a test compares them.
inline constexpr const char* version = "0.1.0";

}  // namespace oplus
