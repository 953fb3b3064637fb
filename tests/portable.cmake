# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of other compilers and systems (platforms/run), where a program may need an emulator.
if(WIN32)
  # By functions of glibc.
  list(FILTER core_tests EXCLUDE REGEX "/parallel_for_test")
endif()
add_executable(oplus-core-tests ${core_tests} main.cpp)
target_link_libraries(oplus-core-tests PRIVATE oplus_families oplus_strict nlohmann_json::nlohmann_json GTest::gtest)
target_compile_options(oplus-core-tests PRIVATE -O0)
if(CMAKE_CXX_FLAGS MATCHES "-stdlib=libc\\+\\+")
  set_source_files_properties(main.cpp PROPERTIES COMPILE_OPTIONS
                              "-include;${CMAKE_CURRENT_SOURCE_DIR}/platforms/printed_numbers.hpp")
endif()
if(MINGW)
  # What is not inlined has a section each, with names that are too long together. GCC 12 misunderstands what is.
  set_source_files_properties(checked/oplus/boost_geometry_test.cpp PROPERTIES COMPILE_OPTIONS
                              "-O1;-Wno-maybe-uninitialized")
endif()
add_test(NAME core COMMAND oplus-core-tests)
set_tests_properties(core PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME cases
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/checked/cli/cases_test.py
                 ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:oplus>)
include(c_interface.cmake)

# What docs/coverage.md is measured by: the tests of the definitions and of all in checked/ but the command line (so not
# engines_test, which asks that), with what they use of properties/.
if(OPLUS_ENGINES)
  file(GLOB_RECURSE covering CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} checked/*_test.cpp)
  list(FILTER covering EXCLUDE REGEX "^checked/(bindings|cli|engines)/")
  file(GLOB definitions CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} reference/definitions/*_test.cpp)
  set(used compare/certified_engine compare/corpus compare/grid_polygons runner/checked_engines runner/child_process
           runner/compared_hole_tests
           runner/source_tree runner/temporary_folder statements/chapter5/boundary_contact statements/laws/convex_hull
           statements/placements/sets_meet)
  list(TRANSFORM used REPLACE "(.+)" ${PROJECT_SOURCE_DIR}/properties/\\1.cpp)
  add_executable(oplus-covering-tests EXCLUDE_FROM_ALL ${covering} ${definitions} corpus/pairs_test.cpp ${used} main.cpp)
  target_compile_definitions(oplus-covering-tests PRIVATE "OPLUS_SOURCE_DIR=\"${PROJECT_SOURCE_DIR}\"")
  target_link_libraries(oplus-covering-tests PRIVATE oplus_engines oplus_families oplus_strict CGAL::CGAL Boost::headers
                                                     nlohmann_json::nlohmann_json GTest::gtest)
  target_compile_options(oplus-covering-tests PRIVATE -O0)
endif()
