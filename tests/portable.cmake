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
