// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/sources.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "properties/compare/conformance_sources.hpp"
#include "properties/compare/grid_polygons.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class PairsOfFolder : public Shell {};

TEST_F(PairsOfFolder, are_parts_and_everything_else_with_each_other) {
  for (const std::string name : {"x_part1.dat", "x_part2.dat", "a.dat", "b.dat", "lone_part1.dat"})
    put(name, "3\n0 0\n1 0\n0 1\n");
  put("readme.txt", "no polygon");
  std::vector<std::string> names;
  for (const Task& pair : pairs_of_folder(folder())) names.push_back(pair.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"a a", "a b", "a lone_part1", "b b", "b lone_part1",
                                             "lone_part1 lone_part1", "x_part1 x_part2"}));
}

class PartsSource : public Shell {};

TEST_F(PartsSource, has_the_sum_of_each_part_and_each_reflected) {
  put("two.wkt", "POLYGON((0 0,1 0,0 1,0 0))\nPOLYGON((0 0,2 0,0 3,0 0))\n");
  const TaskSource source = parts_source(folder() / "two.wkt");
  EXPECT_EQ(source.part, "parts");
  EXPECT_EQ(source.name, "two");
  ASSERT_EQ(source.tasks, 4U);
  const Task task = source.task(2);
  EXPECT_EQ(task.name, "two, P is part 2 and -Q part 1");
  EXPECT_EQ(task.pair,
            (Summands{polygon({{0, 0}, {2, 0}, {0, 3}}), polygon({{0, 0}, {-1, 0}, {0, -1}})}));
}

TEST(Sources, make_the_same_task_for_the_same_number) {
  for (const TaskSource& source : {family_source(*find_family("grid"), 3, 5, std::nullopt),
                                   grid_source(3, 3), corpus_sources().at(0)}) {
    ASSERT_GT(source.tasks, 1U) << source.name;
    EXPECT_EQ(source.task(1).name, source.task(1).name);
    EXPECT_EQ(source.task(1).pair, source.task(1).pair) << source.name;
    EXPECT_NE(source.task(0).pair, source.task(1).pair) << source.name;
  }
}

TEST(Sources, of_a_grid_are_all_orbits_or_an_even_selection) {
  EXPECT_EQ(grid_source(3, 3).tasks, pair_orbits(grid_polygons(3, 3)).size());
  const TaskSource few = grid_source(3, 3, 4);
  EXPECT_EQ(few.tasks, 4U);
  EXPECT_EQ(few.name, "44 polygons of 3 to 3 vertices on 3 x 3 points, 4 of 144 pairs");
  EXPECT_EQ(few.task(3).name, "pair 108 of exhaustive --grid 3 --vertices 3");
}

TEST(Sources, of_given_pairs_ask_the_oracle_and_every_statement) {
  const Summands pair{polygon({{0, 0}, {1, 0}, {0, 1}}), polygon({{0, 0}, {1, 0}, {0, 1}})};
  const std::vector<TaskSource> sources = conformance_sources({Task{"a b", pair}});
  EXPECT_EQ(sources.at(0).name, "a b, by the judge");
  EXPECT_GT(sources.size(), 15U);
  for (const TaskSource& source : sources) {
    EXPECT_EQ(source.task(0).pair, pair);
    EXPECT_EQ(source.task(0).statement == nullptr, &source == &sources[0]);
  }
}

}  // namespace
}  // namespace oplus
