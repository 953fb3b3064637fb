// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// That of CMakeLists.txt; a test compares them.
inline constexpr const char* version = "0.1.0";

/// When it was made, for the manual pages.
inline constexpr const char* version_date = "2026-11-21";

}  // namespace oplus
