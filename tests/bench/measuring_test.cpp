// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/measuring.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "reference/families/fork.hpp"

namespace oplus {
namespace {

Row fork_row(const std::vector<std::string>& engines, double min_time = 0) {
  Row row{.name = "fork",
          .engines = engines,
          .make = [] { return std::vector<Summands>{fork_and_l(3)}; },
          .boundary = Boundary::open};
  std::ostringstream said;
  measure(row, engines, min_time, {.seconds = 10}, said);
  EXPECT_TRUE(said.str().starts_with("fork: "));
  return row;
}

TEST(Measuring, describes_the_measurement) {
  const Row row = fork_row({"rca", "winding"});
  EXPECT_EQ(faults_of(row), std::vector<std::string>());
  EXPECT_EQ(agreement_of(row).compared, 2U);
  for (const auto& [name, value] : std::map<std::string, double>{{"m", 28},
                                                                 {"n", 6},
                                                                 {"sum_holes", 9},
                                                                 {"sum_chains", 1},
                                                                 {"rca.hole_tests", 9},
                                                                 {"winding.hole_tests", 0}})
    EXPECT_EQ(row.number(name), value) << name;
  EXPECT_LT(row.number("rca.edges"), row.number("winding.edges"));
  for (const std::string engine : {"rca", "winding"}) {
    double stages = 0;
    for (const std::string stage :
         {"cycles", "arrangement", "hierarchy", "hole_test", "degenerate"})
      stages += *row.number(engine + '.' + stage);
    EXPECT_NEAR(*row.number(engine + ".time"), stages, 1e-12);
    EXPECT_GT(row.number(engine + ".seconds"), stages);
    EXPECT_GT(row.number(engine + ".peak_mb"), 0);
    EXPECT_EQ(row.number(engine + ".repetitions"), repetitions);
  }
}

TEST(Measuring, repeats_until_the_least_time_is_over) {
  const auto start = std::chrono::steady_clock::now();
  fork_row({"slide"}, 0.3);
  EXPECT_GT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(300));
}

TEST(Measuring, a_crash_of_another_library_is_a_result_and_a_wrong_sum_a_fault) {
  const Row row = fork_row({"crash", "rca", "wrong"});
  EXPECT_EQ(in_words(*row.of("crash")), "crashed: signal 6");
  EXPECT_EQ(row.done("crash"), nullptr);
  EXPECT_EQ(faults_of(row).size(), 1U);
}

TEST(Measuring, a_missing_pair_is_unsupported) {
  EXPECT_EQ(in_words(measured(*find_bench_engine(Subject::sums, "rca"), {}, 0, {})), "missing");
}

}  // namespace
}  // namespace oplus
