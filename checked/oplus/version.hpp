// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The version of oplus, of which the headers are. CMakeLists.txt reads it here.

#define OPLUS_VERSION_MAJOR 1  ///< Grows when programs may not compile with it.
#define OPLUS_VERSION_MINOR 0  ///< Grows when something is added.
#define OPLUS_VERSION_PATCH 0  ///< Grows when only mistakes are mended.
