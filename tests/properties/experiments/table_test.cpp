// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/table.hpp"

#include <gtest/gtest.h>

namespace oplus {
namespace {

const Table table = {
    {"name", "count", "seconds", "same", "missing"},
    {Row{{"name", "a, \"b\""}, {"count", 3}, {"seconds", 0.00123456789}, {"same", true}},
     Row{{"name", "c"}, {"count", nullptr}, {"seconds", 12.0}, {"same", false}}}};

TEST(Table, csv_quotes_and_leaves_cells_empty) {
  EXPECT_EQ(to_csv(table),
            "name,count,seconds,same,missing\n"
            "\"a, \"\"b\"\"\",3,0.00123457,true,\n"
            "c,,12,false,\n");
}

TEST(Table, markdown_shows_the_chosen_columns_with_their_factors) {
  EXPECT_EQ(to_markdown(table, {{"pair", "name"},
                                {"n", "count"},
                                {"ms", "seconds", 1000},
                                {"equal", "same"},
                                {"none", "missing"}}),
            "| pair | n | ms | equal | none |\n"
            "|---|---|---|---|---|\n"
            "| a, \"b\" | 3 | 1.23 | yes | – |\n"
            "| c | – | 12000 | no | – |\n");
}

TEST(Table, a_cell_cannot_break_a_markdown_table) {
  EXPECT_EQ(to_markdown({{"x"}, {Row{{"x", "a|b\nc"}}}}, {{"x", "x"}}),
            "| x |\n|---|\n| a/b c |\n");
}

TEST(Table, three_significant_digits) {
  EXPECT_EQ(shown(0), "0");
  EXPECT_EQ(shown(1), "1.00");
  EXPECT_EQ(shown(0.012345), "0.0123");
  EXPECT_EQ(shown(123.456), "123");
  EXPECT_EQ(shown(1234567), "1234567");
  EXPECT_EQ(shown(-2.5), "-2.50");
}

TEST(Table, points_are_of_rows_that_have_both) {
  const Points found = points(table, "count", "seconds");
  EXPECT_EQ(found.x, std::vector<double>({3}));
  EXPECT_EQ(found.y, std::vector<double>({0.00123456789}));
  EXPECT_TRUE(points(table, "name", "seconds").x.empty());
}

}  // namespace
}  // namespace oplus
