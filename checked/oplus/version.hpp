// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The version of oplus, of which the headers are. CMakeLists.txt reads it here.

#define OPLUS_VERSION_MAJOR 0  ///< As in semantic versioning.
#define OPLUS_VERSION_MINOR 1  ///< While MAJOR is 0, programs may not compile with the next one.
#define OPLUS_VERSION_PATCH 0  ///< Changes where only mistakes are mended.
