// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <iostream>

// GoogleTest's own main() succeeds where a filter matches no case, and where cases are skipped.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  if (failed != 0 || GTEST_FLAG_GET(list_tests)) return failed;
  const testing::UnitTest& run = *testing::UnitTest::GetInstance();
  if (run.test_to_run_count() == 0) {
    std::cerr << "no case matches " << GTEST_FLAG_GET(filter) << '\n';
    return 1;
  }
  // Which CTest then lists as skipped: SKIP_RETURN_CODE.
  return run.skipped_test_count() > 0 ? 77 : 0;
}
