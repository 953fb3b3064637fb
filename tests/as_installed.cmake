# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of what users get: the public headers, examples, Python, the page, packages; and measurements.
# The libraries are compiled as users compile them; of the tests warnings are errors here, too.
add_compile_options(-Werror)
add_executable(oplus-public-tests ${public_tests} reference/definitions/contract_test.cpp main.cpp)
target_link_libraries(oplus-public-tests PRIVATE oplus_engines oplus_strict CGAL::CGAL GTest::gtest)
target_compile_options(oplus-public-tests PRIVATE -O0)
oplus_tests_by_file(oplus-public-tests release. ${public_tests} reference/definitions/contract_test.cpp)

# Programs that show the public functions, compiled with the headers as they are installed.
add_custom_target(examples)
file(GLOB examples CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/examples/cpp/*.cpp)
foreach(source IN LISTS examples)
  get_filename_component(example ${source} NAME_WE)
  add_executable(example-${example} ${source})
  target_link_libraries(example-${example} PRIVATE oplus::oplus oplus_strict)
  target_compile_options(example-${example} PRIVATE -O0)
  add_dependencies(examples example-${example})
  add_test(NAME example.${example}
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/docs/example_program
                   $<TARGET_FILE:example-${example}> ${source})
endforeach()
target_link_libraries(example-engines PRIVATE oplus::engines)
foreach(example cgal from_cgal)
  target_link_libraries(example-${example} PRIVATE oplus::cgal)
endforeach()
target_include_directories(example-from_clipper SYSTEM PRIVATE ${CLIPPER_INCLUDE_DIR})
target_link_libraries(example-from_clipper PRIVATE ${CLIPPER_LIBRARY})
add_test(NAME docs.readme-program
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/readme_program.py)
# The C interface, in a program of C and in those of other languages.
include(c_interface.cmake)
add_test(NAME c.exported COMMAND ${Python3_EXECUTABLE} -B ${of_c}/exported.py $<TARGET_FILE:oplus_c>)
foreach(language c rs lua)
  add_test(NAME c.example-${language}
           COMMAND bash ${of_c}/example $<TARGET_FILE_DIR:oplus_c> ${PROJECT_BINARY_DIR}/include
                   ${PROJECT_SOURCE_DIR}/docs/examples/c/room_and_robot.${language})
endforeach()

# The Python package: pytest, Hypothesis, and the examples of docstrings.
add_test(NAME python.package
         COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${PROJECT_BINARY_DIR}/python
                 ${Python_EXECUTABLE} -B -m pytest -q -p no:cacheprovider ${CMAKE_CURRENT_SOURCE_DIR}/checked/bindings/python)
# The notebooks of docs/examples.
add_test(NAME python.notebooks
         COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${PROJECT_BINARY_DIR}/python PYDEVD_DISABLE_FILE_VALIDATION=1
                 ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/checked/bindings/python/run_notebooks.py)

add_test(NAME docs.nesting
         COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${PROJECT_BINARY_DIR}/python
                 ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/nesting_test.py $<TARGET_FILE:oplus>)

# The page (docs/web.md).
set(page ${CMAKE_CURRENT_BINARY_DIR}/page)
add_test(NAME page.build COMMAND ${CMAKE_COMMAND} -E env OPLUS_WARNINGS_ARE_ERRORS=ON OPLUS_BUILD=${PROJECT_BINARY_DIR}
                                bash ${PROJECT_SOURCE_DIR}/checked/bindings/page/make ${page})
# The longest first.
set_tests_properties(page.build PROPERTIES FIXTURES_SETUP page COST 1000)
add_test(NAME page.core
         COMMAND node ${CMAKE_CURRENT_SOURCE_DIR}/checked/bindings/page/core_test.mjs ${page} $<TARGET_FILE:oplus>
                 ${CMAKE_CURRENT_SOURCE_DIR}/corpus/pairs.txt ${cases})
# axe-core judges what screen readers and keyboards find.
add_test(NAME page.axe-core COMMAND npm install --loglevel=error --no-audit --no-fund --prefix ${page}-tools axe-core@4.14.1)
set_tests_properties(page.axe-core PROPERTIES FIXTURES_SETUP axe-core)
set(of_page axe gallery loading operations page proofs sliding taking)
foreach(test ${of_page})
  add_test(NAME page.browser-${test}
           COMMAND ${CMAKE_COMMAND} -E env OPLUS_PAGE=${page} OPLUS_AXE=${page}-tools/node_modules/axe-core/axe.min.js
                   ${Python_EXECUTABLE} -B -m pytest -q -p no:cacheprovider
                   ${CMAKE_CURRENT_SOURCE_DIR}/checked/bindings/page/${test}_test.py)
endforeach()
list(TRANSFORM of_page PREPEND page.browser-)
set_tests_properties(page.core ${of_page} PROPERTIES FIXTURES_REQUIRED page)
set_tests_properties(page.browser-axe PROPERTIES FIXTURES_REQUIRED "page;axe-core")

# The npm module (docs/npm.md): what `npm pack` makes, in an empty folder.
set(npm ${CMAKE_CURRENT_BINARY_DIR}/npm)
set(of_npm ${CMAKE_CURRENT_SOURCE_DIR}/checked/bindings/npm)
add_test(NAME npm.build COMMAND ${CMAKE_COMMAND} -E env OPLUS_WARNINGS_ARE_ERRORS=ON
                                bash ${PROJECT_SOURCE_DIR}/checked/bindings/npm/make ${npm}/module)
add_test(NAME npm.install COMMAND bash ${of_npm}/install ${npm}/module ${npm}/installed)
add_test(NAME npm.node COMMAND node --expose-gc ${npm}/installed/oplus_test.mjs ${cases})
add_test(NAME npm.browser COMMAND ${Python_EXECUTABLE} -B ${of_npm}/browser_test.py ${npm}/installed)
# They share object files.
set_tests_properties(npm.build page.build PROPERTIES RESOURCE_LOCK wasm)
set_tests_properties(npm.build PROPERTIES FIXTURES_SETUP npm-module COST 900)
set_tests_properties(npm.install PROPERTIES FIXTURES_SETUP npm FIXTURES_REQUIRED npm-module)
set_tests_properties(npm.node npm.browser PROPERTIES FIXTURES_REQUIRED npm)

# The API reference: everything in it is documented, and every function is in an example.
add_test(NAME docs.api COMMAND bash ${PROJECT_SOURCE_DIR}/docs/api/make ${CMAKE_CURRENT_BINARY_DIR}/api)
add_test(NAME docs.api-in-examples
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/api_in_examples.py
                 ${CMAKE_CURRENT_BINARY_DIR}/api/xml)
set_tests_properties(docs.api PROPERTIES FIXTURES_SETUP api)
set_tests_properties(docs.api-in-examples PROPERTIES FIXTURES_REQUIRED api)
# The site with the page to draw on, and what leads where on it.
add_test(NAME docs.site COMMAND ${CMAKE_COMMAND} -E env OPLUS_BUILD=${PROJECT_BINARY_DIR}
                                bash ${PROJECT_SOURCE_DIR}/docs/site/make
                                ${CMAKE_CURRENT_BINARY_DIR}/site ${page})
add_test(NAME docs.site-links
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/site_links.py
                 ${CMAKE_CURRENT_BINARY_DIR}/site)
set_tests_properties(docs.site PROPERTIES FIXTURES_SETUP site FIXTURES_REQUIRED page)
set_tests_properties(docs.site-links PROPERTIES FIXTURES_REQUIRED site)
# What the adapters refuse at compile time, and what they include.
foreach(test refused_kernel cgal_licence)
  add_test(NAME checked/oplus/${test}
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/checked/oplus/${test} ${CMAKE_CXX_COMPILER})
endforeach()

# Measurements: oplus beside others, and the thesis's experiments.
find_package(benchmark REQUIRED)
file(GLOB benchmark_sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}
     bench/*.cpp bench/*.hpp)
add_executable(oplus-bench ${benchmark_sources})
target_include_directories(oplus-bench SYSTEM PRIVATE ${CLIPPER_INCLUDE_DIR})
target_link_libraries(oplus-bench PRIVATE oplus_runner oplus_peers oplus_strict
                                          CGAL::CGAL benchmark::benchmark ${CLIPPER_LIBRARY})
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}" bench_flags)
set_source_files_properties(bench/main.cpp PROPERTIES COMPILE_DEFINITIONS
                            "OPLUS_BENCH_FLAGS=\"${bench_flags}\"")
# What oplus's command is measured beside.
foreach(library cgal clipper)
  add_executable(${library}-sum bench/programs/${library}_sum.cpp)
  target_link_libraries(${library}-sum PRIVATE oplus_strict)
  add_dependencies(oplus-bench ${library}-sum oplus)
endforeach()
# What Python's calls are measured beside: bench/python_calls.py.
add_executable(small-sums bench/programs/small_sums.cpp)
target_link_libraries(small-sums PRIVATE oplus_core oplus_strict)
if(TARGET oplus-proved)
  add_dependencies(oplus-bench oplus-certified oplus-proved)
endif()
target_link_libraries(cgal-sum PRIVATE CGAL::CGAL)
target_include_directories(clipper-sum SYSTEM PRIVATE ${CLIPPER_INCLUDE_DIR})
target_link_libraries(clipper-sum PRIVATE ${CLIPPER_LIBRARY})
# How fast anything is depends on the machine; that all engines start and agree does not.
add_test(NAME bench.programs
         COMMAND ${CMAKE_COMMAND} -E env OPLUS_BENCH=$<TARGET_FILE:oplus-bench>
                 ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/bench/programs_test.py)

# What is wrong with other libraries, shown by a program each.
file(GLOB findings CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/findings/*.cpp)
# Those of Clipper2 are compiled with the newest Debian's, below.
list(FILTER findings EXCLUDE REGEX "/clipper2_[^/]*$")
foreach(source IN LISTS findings)
  get_filename_component(finding ${source} NAME_WE)
  add_executable(finding-${finding} ${source})
  target_include_directories(finding-${finding} SYSTEM PRIVATE ${CLIPPER_INCLUDE_DIR})
  target_link_libraries(finding-${finding} PRIVATE CGAL::CGAL ${CLIPPER_LIBRARY})
  target_compile_options(finding-${finding} PRIVATE -O0)
  add_test(NAME finding.${finding}
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/docs/finding_program
                   $<TARGET_FILE:finding-${finding}> ${source})
endforeach()

# The newest CGAL and Clipper2 of Debian, which need its network.
add_test(NAME newest.libraries
         COMMAND bash ${PROJECT_SOURCE_DIR}/properties/compare/peers/newest ${PROJECT_BINARY_DIR})
add_test(NAME newest.peer
         COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/properties/compare/peers/newest ${PROJECT_BINARY_DIR})
set_tests_properties(newest.libraries PROPERTIES FIXTURES_SETUP newest COST 500)
set(with_newest newest.peer)
file(GLOB findings CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/findings/clipper2_*.cpp)
foreach(source IN LISTS findings)
  get_filename_component(finding ${source} NAME_WE)
  add_test(NAME finding.${finding}
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/docs/finding_with_newest ${PROJECT_BINARY_DIR}/newest
                   ${source})
  list(APPEND with_newest finding.${finding})
endforeach()
set_tests_properties(${with_newest} PROPERTIES FIXTURES_REQUIRED newest)
set_tests_properties(newest.libraries ${with_newest} PROPERTIES SKIP_RETURN_CODE 77)

add_test(NAME tree.release-contains-no-mutant
         COMMAND ${tree_check}/mutant_names.py absent $<TARGET_FILE:oplus>
                 $<TARGET_FILE:oplus_core> $<TARGET_FILE:oplus_engines>)

add_test(NAME consumer.find-package
         COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/consumer/install_and_use ${PROJECT_BINARY_DIR})
# The core where there is no CGAL; workflows call it on other systems.
add_test(NAME consumer.core COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/consumer/core)

# The archive of the sources, and what builds from it.
add_test(NAME packages.recipes
         COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/checked/install/recipes/build ${PROJECT_BINARY_DIR})
set_tests_properties(packages.recipes PROPERTIES TIMEOUT 2400 COST 700)
# The packages of Debian, in a system of its own.
add_test(NAME packages.deb
         COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/checked/install/install_deb ${PROJECT_BINARY_DIR})
set_tests_properties(packages.deb PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 2400 COST 800)
# A wheel of the light core.
add_test(NAME packages.wheel
         COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/checked/install/install_wheel ${PROJECT_BINARY_DIR} ${PROJECT_VERSION})
set_tests_properties(packages.wheel PROPERTIES TIMEOUT 1200 COST 600)

# Other compilers, libraries and systems, one after another from the start, beside the other tests; platforms/run has more,
# which take hours.
foreach(row newest windows "--core aarch64" "--core gcc-14-c++23" "--core clang-16-libc++" "--core clang-19-libc++-c++23")
  separate_arguments(row)
  list(GET row -1 name)
  add_test(NAME platforms.${name} COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/platforms/run ${row})
  set_tests_properties(platforms.${name} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 7200 COST 2000
                       RESOURCE_LOCK platforms)
endforeach()
