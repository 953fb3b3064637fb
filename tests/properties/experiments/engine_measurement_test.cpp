// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/engine_measurement.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "properties/experiments/engine_tables.hpp"
#include "reference/families/fork.hpp"

namespace oplus {
namespace {

using Kind = ProcessReport::Kind;

Row measured_fork() {
  return measured_engines([] { return fork_and_l(3); }, 0);
}

TEST(EngineMeasurement, fills_every_column_and_no_other) {
  const Row row = measured_fork();
  std::size_t filled = 0;
  for (const std::string& column : engine_columns()) {
    EXPECT_TRUE(row.contains(column)) << column;
    ++filled;
  }
  EXPECT_EQ(row.size(), filled);
}

TEST(EngineMeasurement, says_what_was_measured) {
  const Row row = measured_fork();
  EXPECT_TRUE(is_complete(row));
  EXPECT_EQ(fault_of(row), "");
  EXPECT_EQ(row.at("m"), 28);
  EXPECT_EQ(row.at("n"), 6);
  EXPECT_EQ(row.at("sum_holes"), 9);
  EXPECT_EQ(row.at("rca_hole_tests"), 9);
  EXPECT_EQ(row.at("winding_hole_tests"), 0);
  EXPECT_LT(row.at("rca_edges"), row.at("winding_edges"));
  EXPECT_TRUE(row.at("same_sum"));
  for (const std::string engine : {"rca", "winding"}) {
    double stages = 0;
    for (const std::string stage :
         {"cycles", "arrangement", "hierarchy", "hole_test", "degenerate"})
      stages += row.at(engine + '_' + stage).get<double>();
    EXPECT_DOUBLE_EQ(row.at(engine + "_time").get<double>(), stages);
    EXPECT_GT(row.at(engine + "_peak_mb"), 0);
    EXPECT_EQ(row.at(engine + "_repetitions"), 5);
  }
}

TEST(EngineMeasurement, a_pair_whose_making_fails_is_a_row) {
  const Row row = measured_engines([]() -> Summands { ::abort(); }, 0);
  EXPECT_EQ(row.at("rca_outcome"), "killed by signal 6, Aborted");
  EXPECT_FALSE(is_complete(row));
  EXPECT_FALSE(row.contains("same_sum"));
  EXPECT_FALSE(row.contains("rca_time"));
  std::vector<std::string> wrong;
  add_faults(row, "the pair", wrong);
  EXPECT_EQ(wrong, std::vector<std::string>({"the pair: rca killed by signal 6, Aborted; winding "
                                             "killed by signal 6, Aborted"}));
}

TEST(EngineMeasurement, out_of_memory_is_a_row_and_no_fault) {
  const ProcessReport none{Kind::out_of_memory, "out of memory", 3};
  const Row row = row_of(none, none);
  EXPECT_EQ(row.at("winding_outcome"), "out of memory");
  EXPECT_EQ(fault_of(row), "");
  EXPECT_EQ(progress_line("pair", row), "pair: rca out of memory, winding out of memory");
}

TEST(EngineMeasurement, sums_that_differ_are_a_fault) {
  const auto report = [](const std::string& digest) {
    Row found = {{"digest", digest}};
    for (const std::string& column : engine_columns()) found[column] = 1;
    for (const std::string& column : engine_columns())
      if (column.starts_with("rca_")) found[column.substr(4)] = 1;
    return ProcessReport{Kind::done, found.dump(), 1};
  };
  EXPECT_EQ(fault_of(row_of(report("a"), report("a"))), "");
  EXPECT_EQ(fault_of(row_of(report("a"), report("b"))), "the sums differ");
}

TEST(EngineMeasurement, the_index_says_first_last_and_median_ratio) {
  const Table table = {{},
                       {Row{{"ratio", 3.0}, {"ratio_with_output", 1.0}}, Row::object(),
                        Row{{"ratio", 1.0}, {"ratio_with_output", 1.0}},
                        Row{{"ratio", 2.0}, {"ratio_with_output", 1.0}}}};
  EXPECT_EQ(ratio_lines(table),
            std::vector<std::string>(
                {"T_RC / T_W: 3.00 at the first row, 2.00 at the last, median 2.00",
                 "T_RC / T_W with output: 1.00 at the first row, 1.00 at the last, median 1.00"}));
  EXPECT_TRUE(ratio_lines({}).empty());
}

}  // namespace
}  // namespace oplus
