# SPDX-License-Identifier: GPL-3.0-or-later
# The C interface, in a program of C.
enable_language(C)
set(of_c ${CMAKE_CURRENT_SOURCE_DIR}/checked/bindings/c)
add_executable(oplus-c-test ${of_c}/oplus_test.c)
target_link_libraries(oplus-c-test PRIVATE oplus::c Threads::Threads)
target_compile_options(oplus-c-test PRIVATE -std=c99 -Wall -Wextra -Wpedantic -Wstrict-prototypes)
target_compile_definitions(oplus-c-test PRIVATE _XOPEN_SOURCE=700 "OPLUS_VERSION=\"${PROJECT_VERSION}\"")
add_test(NAME c.functions COMMAND oplus-c-test)
