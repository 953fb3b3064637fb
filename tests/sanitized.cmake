# SPDX-License-Identifier: GPL-3.0-or-later
# Tests with sanitizers, of the core alone: what users call, what reads, and what the fuzz targets leave out.
set(sources ${core_tests})
list(FILTER sources INCLUDE REGEX "^checked/(operations|oplus|repair)/|^checked/(rounding/rounding|verify/(damaged_sums|closeness))_test|^reference/(chains/validity_test|io/)")
add_executable(oplus-sanitized-tests ${sources} main.cpp)
target_link_libraries(oplus-sanitized-tests PRIVATE oplus_families oplus_strict GTest::gtest)
target_compile_options(oplus-sanitized-tests PRIVATE -O0)
oplus_tests_by_file(oplus-sanitized-tests sanitized. ${sources})
