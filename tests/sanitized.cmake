# SPDX-License-Identifier: GPL-3.0-or-later
# Tests with sanitizers, of the core alone: what users call, what reads, and what the fuzz targets leave out.
file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}
     checked/operations/*_test.cpp checked/repair/*_test.cpp checked/rounding/rounding_test.cpp
     checked/verify/damaged_sums_test.cpp checked/verify/closeness_test.cpp
     reference/chains/validity_test.cpp reference/io/*_test.cpp)
list(APPEND sources ${public_tests})
# They need CGAL, the comparison, or the command line.
list(FILTER sources EXCLUDE REGEX "/(cgal|engines|region_lines|round_trip|reading|write_file|set_sum|operations_of_sets|inner_fit_in_convex)_test")
add_executable(oplus-sanitized-tests ${sources} main.cpp)
target_link_libraries(oplus-sanitized-tests PRIVATE oplus_families oplus_strict GTest::gtest)
target_compile_options(oplus-sanitized-tests PRIVATE -O0)
oplus_tests_by_file(oplus-sanitized-tests sanitized. ${sources})
