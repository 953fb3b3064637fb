# SPDX-License-Identifier: MIT
# oplus::oplus, and oplus::engines where it was installed.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/oplus-core.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/oplus-engines.cmake OPTIONAL)
