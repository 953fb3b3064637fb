// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/crash_site.hpp"

#include <gtest/gtest.h>

namespace oplus {
namespace {

TEST(CrashSite, of_cgal_is_the_header_the_line_and_the_expression) {
  EXPECT_EQ(
      crash_site("terminate called after throwing an instance of 'CGAL::Assertion_exception'\n"
                 "CGAL error: assertion violation!\n"
                 "Expression : sl_iter != m_statusLine.end()\n"
                 "File       : /usr/include/CGAL/Surface_sweep_2/impl.h\n"
                 "Line       : 547\n"
                 "Explanation: none\n",
                 "SIGABRT"),
      "CGAL/Surface_sweep_2/impl.h:547: sl_iter != m_statusLine.end()");
  EXPECT_EQ(crash_site("CGAL error: precondition violation!\n", "SIGABRT"), "SIGABRT");
}

TEST(CrashSite, of_assert_is_the_file_the_line_and_the_expression) {
  EXPECT_EQ(
      crash_site("before\na.out: /tmp/x/a.cpp:12: int main(): Assertion `a::b(\"x: y\") == 1' "
                 "failed.\nAborted\n",
                 "SIGABRT"),
      "a.cpp:12: a::b(\"x: y\") == 1");
  EXPECT_EQ(crash_site("Assertion `' failed.", "SIGABRT"), "SIGABRT");
}

TEST(CrashSite, of_a_sanitizer_is_what_it_found_without_addresses) {
  EXPECT_EQ(
      crash_site("==7==ERROR: AddressSanitizer: heap-use-after-free on address 0x61\n", "exit"),
      "AddressSanitizer: heap-use-after-free");
}

TEST(CrashSite, of_an_exception_is_its_type) {
  EXPECT_EQ(crash_site("terminate called after throwing an instance of 'std::out_of_range'\n"
                       "  what():  vector::_M_range_check: __n (which is 7)\n",
                       "SIGABRT"),
            "'std::out_of_range'");
}

TEST(CrashSite, is_how_it_ended_where_nothing_is_known) {
  EXPECT_EQ(crash_site("", "SIGSEGV"), "SIGSEGV");
  EXPECT_EQ(crash_site("no such luck\n", "exit code 1"), "exit code 1");
}

TEST(SaysOutOfMemory, knows_the_usual_words_and_no_others) {
  for (const char* text :
       {"what():  std::bad_alloc", "GNU MP: Cannot allocate memory (size=8)", "MemoryError",
        "dd: memory exhausted by input buffer", "java.lang.OutOfMemoryError"})
    EXPECT_TRUE(says_out_of_memory(text)) << text;
  EXPECT_FALSE(says_out_of_memory("Segmentation fault"));
  EXPECT_FALSE(says_out_of_memory(""));
}

}  // namespace
}  // namespace oplus
