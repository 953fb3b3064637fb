// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace oplus {
namespace {

Rows rows() {
  const Measurement rca{
      .engine = "rca", .digest = "a", .numbers = {{"time", 0.5}, {"sum_holes", 2}, {"m", 4}}};
  Measurement lost = rca;
  lost.outcome = Measurement::Ending::out_of_memory;
  return {{.words = {{"name", "a, \"b\""}, {"same", "true"}},
           .numbers = {{"count", 3}, {"seconds", 0.00123456789}},
           .measurements = {rca}},
          {.words = {{"name", "c|d\ne"}, {"same", "false"}},
           .numbers = {{"seconds", 12}},
           .measurements = {lost}}};
}

TEST(Table, csv_quotes_and_leaves_cells_empty) {
  EXPECT_EQ(to_csv(rows(), {"name", "nothing", "same"}),
            "name,nothing,same,count,m,rca_outcome,rca_time,seconds,sum_holes\n"
            "\"a, \"\"b\"\"\",,true,3,4,done,0.5,0.00123457,2\n"
            "\"c|d\ne\",,false,,,out of memory,,12,\n");
}

TEST(Table, shows_words_numbers_and_outcomes) {
  const Table table =
      table_of(rows(), columns_of("pair = name; n = count; ms = 1000 seconds; equal = same; "
                                  "RC = rca.outcome; T = 1000 rca.time; by = 1 rca.time/seconds; "
                                  "power = e seconds; holes = sum_holes; W = winding.time"));
  using Cells = std::vector<std::string>;
  EXPECT_EQ(table.head,
            Cells({"pair", "n", "ms", "equal", "RC", "T", "by", "power", "holes", "W"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0],
            Cells({"a, \"b\"", "3", "1.23", "yes", "done", "500", "405", "1.2e-03", "2", ""}));
  // No cell can break a table of Markdown.
  EXPECT_EQ(table.rows[1],
            Cells({"c/d e", "", "12,000", "no", "out of memory", "", "", "1.2e+01", "", ""}));
}

TEST(Table, the_first_column_has_the_outcome_instead_of_a_number) {
  EXPECT_EQ(table_of(rows(), columns_of("T = 1 rca.time; again = 1 rca.time")).rows[1],
            std::vector<std::string>({"out of memory", ""}));
  EXPECT_THROW(columns_of("T: rca.time"), std::invalid_argument);
}

TEST(Table, points_are_of_rows_that_have_both_numbers) {
  const Points found = points(rows(), "count", "seconds");
  EXPECT_EQ(found.x, std::vector<double>({3}));
  EXPECT_EQ(found.y, std::vector<double>({0.00123456789}));
  EXPECT_TRUE(points(rows(), "name", "seconds").x.empty());
}

}  // namespace
}  // namespace oplus
