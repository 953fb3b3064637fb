# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of the build with contracts and mutants: all units, the properties and that they bite, the proofs
# beside the code, the tree.
file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}
     ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*.hpp)
list(FILTER sources EXCLUDE REGEX "^(consumer|bench|checked/oplus)/")
set(test_sources ${sources})
list(FILTER test_sources INCLUDE REGEX "_test\\.cpp$")
add_executable(oplus-tests ${sources} main.cpp)
target_link_libraries(oplus-tests PRIVATE oplus_cli oplus_properties oplus_peers oplus_strict
                                          CGAL::CGAL GTest::gtest)
# What is tested is optimised; the tests need not be, and were half of the time to build.
target_compile_options(oplus-tests PRIVATE -O0)
add_dependencies(oplus-tests oplus oplus-check oplus-maintain oplus-peer)
if(TARGET oplus-certified)
  add_dependencies(oplus-tests oplus-certified oplus-proved)
endif()
# As in the libraries, and GoogleTest; compiled as the tests are.
if(TARGET oplus_precompiled)
  target_precompile_headers(oplus-tests PRIVATE
    <algorithm> <array> <filesystem> <fstream> <functional> <iostream> <map> <memory> <optional> <set>
    <sstream> <string> <vector> <gmpxx.h> <gtest/gtest.h>)
endif()
oplus_tests_by_file(oplus-tests "" ${test_sources})
add_test(NAME checked/cli/cases
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/checked/cli/cases_test.py $<TARGET_FILE:oplus>)
add_test(NAME checked/cli/lasting-batches
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/checked/cli/lasting_batches_test.py $<TARGET_FILE:oplus>)

# The fuzz targets find them, too.
add_executable(oplus-planted-faults properties/fuzz/planted_faults.cpp)
target_link_libraries(oplus-planted-faults PRIVATE oplus_properties oplus_strict)
add_test(NAME check.fuzz-finds-planted-faults
         COMMAND oplus-planted-faults ${PROJECT_SOURCE_DIR}/docs/fuzz.md)

# What they did must be what the pages say they do; bash docs/renew records it anew.
set(recorded ${PROJECT_SOURCE_DIR}/docs/theorems)
foreach(part RANGE 1 4)
  add_test(NAME check.properties-${part}
           COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/properties/runner/as_recorded.py
                   $<TARGET_FILE:oplus-maintain> ${recorded}/runs.json ${part} 4)
  list(APPEND parts check.properties-${part})
endforeach()
add_test(NAME check.mutants COMMAND oplus-maintain mutants --record kills.json)
# The longest first, lest they be what a core is left alone with.
set_tests_properties(${parts} check.mutants PROPERTIES COST 1000 FIXTURES_SETUP pictures)
add_test(NAME check.mutants-as-recorded COMMAND diff -u ${recorded}/kills.json kills.json)
add_test(NAME check.pictures-as-recorded
         COMMAND bash -c "rm -f pictures/*-typical.svg; cp runs-?/pictures/* pictures && diff -r ${recorded}/pictures pictures")
set_tests_properties(check.mutants-as-recorded check.pictures-as-recorded PROPERTIES FIXTURES_REQUIRED pictures)
add_test(NAME check.pages COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/properties/pages/pages.py
                                  --program $<TARGET_FILE:oplus-check> --check)
add_test(NAME check.pages-bite
         COMMAND ${Python3_EXECUTABLE} -B -m unittest discover -v -p "*_test.py"
         WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/properties/pages)
# What Z3 and cvc5 prove is the code itself (docs/smt.md): with a fault in it they find counterexamples.
foreach(fault_and_queries
        acute-vertex-is-reflex:theorem-2.3.2
        left-and-right-are-one-direction:definition-2.2.7.tie-rule-p
        reflex-turns-clockwise:table-4.3-to-4.6
        slide-shifts-to-the-left:step-interval
        tangent-set-without-ties:definition-2.2.7)
  string(REPLACE ":" ";" both ${fault_and_queries})
  list(GET both 0 fault)
  list(GET both 1 queries)
  add_test(NAME check.smt-finds-${fault} COMMAND oplus-maintain smt ${queries} --mutant ${fault})
  set_tests_properties(check.smt-finds-${fault} PROPERTIES LABELS proofs
    PASS_REGULAR_EXPRESSION "proof, z3: is sat.*proof, cvc5: is sat")
endforeach()
# In the libraries, not in oplus-check: its registry names them in every build.
add_test(NAME check.contains-every-mutant
         COMMAND ${tree_check}/mutant_names.py present $<TARGET_FILE:oplus_core>
                 $<TARGET_FILE:oplus_engines> $<TARGET_FILE:oplus_families>)

# Every pair of triangles and quadrangles on 3 x 3 points.
add_test(NAME exhaustive.grid-3 COMMAND oplus-check exhaustive --grid 3 --vertices 4 --threads 1)

# What docs/conformance.md says about one's own program.
add_test(NAME conformance.own-program
         COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/properties/compare/own_program
                 $<TARGET_FILE:oplus-check>)

# A campaign in shards.
add_test(NAME campaigns.shards
         COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/properties/compare/shards $<TARGET_FILE:oplus-check>)

add_subdirectory(properties/proofs)

# Statements about a few directions, by Z3 and cvc5 (docs/smt.md).
add_test(NAME proofs.smt COMMAND oplus-check smt)
set_tests_properties(proofs.smt PROPERTIES LABELS proofs)

# What the pages of docs/ draw, link to and name.
add_test(NAME docs.pages
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/pages_test.py $<TARGET_FILE:oplus>)
add_test(NAME docs.parallel
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/parallel_test.py $<TARGET_FILE:oplus>)
# What docs/benchmarks.md and docs/experiments are made with, on a program that stands for oplus-bench.
add_test(NAME docs.benchmarks
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/bench/table_test.py)
# docs/scoreboard.md, its record and its pictures; docs/scoreboard/make takes minutes.
add_test(NAME docs.scoreboard
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/scoreboard_test.py)


add_test(NAME tree.layering COMMAND ${tree_check}/layering.py)
add_test(NAME tree.architecture COMMAND ${tree_check}/architecture.py)
add_test(NAME tree.licence-lines COMMAND ${tree_check}/licence_lines.py)
add_test(NAME tree.format COMMAND ${tree_check}/formatted.py)
add_test(NAME tree.public-headers COMMAND ${tree_check}/public_headers.py)
add_test(NAME tree.page-algorithms COMMAND ${tree_check}/page_algorithms.py)
add_test(NAME tree.project-files COMMAND ${tree_check}/project_files.py)
add_test(NAME tree.nothing-outside-the-build
         COMMAND ${tree_check}/compiled.py ${PROJECT_SOURCE_DIR}/build/check/compile_commands.json
                 ${PROJECT_SOURCE_DIR}/build/release/compile_commands.json
                 ${PROJECT_SOURCE_DIR}/build/fuzz/compile_commands.json)
add_test(NAME tree.checks-bite
         COMMAND ${Python3_EXECUTABLE} -B -m unittest discover -v -p "*_test.py"
         WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/tree)

