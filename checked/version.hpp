// SPDX-License-Identifier: MIT
#pragma once

namespace oplus {

/// That of project() in CMakeLists.txt.
extern const char* const version;

}  // namespace oplus
