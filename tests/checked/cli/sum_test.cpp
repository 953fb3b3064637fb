// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "properties/runner/source_tree.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Sum : public ShellWithRegions {
 protected:
  Sum() {
    // A square of side 2 fits into the frame's hole in one place, and a bar of side 1 along a segment.
    put("plug.wkt", "POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))");
    put("slider.wkt", "POLYGON ((-1 0, 1 0, 1 1, -1 1, -1 0))");
  }
};

TEST_F(Sum, every_engine_finds_the_same) {
  for (const std::string other : {"plug.wkt", "slider.wkt", "triangle.dat", "frame.wkt"}) {
    for (const std::string open : {"", " --open"}) {
      const std::string command = "oplus sum frame.wkt " + other + open;
      const Ran ran = run(command + " --origins default.json", 0);
      for (const std::string how :
           {"--engine slide", "--engine rca", "--engine loops", "--engine winding",
            "--engine oracle", "--threads 0", "--threads 1", "--threads 2", "--threads 7"}) {
        EXPECT_EQ(run(command + " --origins o.json " + how).out, ran.out) << command << how;
        EXPECT_EQ(content("default.json"), content("o.json")) << command << how;
      }
      for (const std::string hole_test : {"bvh", "sweep", "naive", "ray"})
        EXPECT_EQ(run(command + " --engine rca --collision-test " + hole_test).out, ran.out)
            << command << hole_test;
    }
  }
}

TEST_F(Sum, origins_are_sums_along_the_edge) {
  run("oplus sum square.wkt triangle.dat --origins o.json");
  const auto list = nlohmann::json::parse(content("o.json"));
  ASSERT_EQ(list.size(), 5U);
  // Along the bottom run the bottom of each summand, from the corner of the other.
  const auto& bottom = list.at(0);
  EXPECT_EQ(bottom.at("kind"), "outer");
  EXPECT_EQ(bottom.at("from"), nlohmann::json({"0", "0"}));
  EXPECT_EQ(bottom.at("to"), nlohmann::json({"2", "0"}));
  ASSERT_EQ(bottom.at("origins").size(), 2U);
  // The slanted edge is the triangle's, at the square's corner (1, 1).
  const auto& slanted = list.at(2);
  EXPECT_EQ(slanted.at("from"), nlohmann::json({"2", "1"}));
  ASSERT_EQ(slanted.at("origins").size(), 1U);
  const auto& origin = slanted.at("origins").at(0);
  EXPECT_EQ(
      origin.at("edge"),
      nlohmann::json(
          {{"of", "Q"}, {"chain", 0}, {"leaves", 1}, {"from", {"1", "0"}}, {"to", {"0", "1/3"}}}));
  EXPECT_EQ(origin.at("vertex"),
            nlohmann::json({{"of", "P"}, {"chain", 0}, {"index", 2}, {"at", {"1", "1"}}}));
}

TEST_F(Sum, stats_show_the_published_arrangement_sizes) {
  const std::string data = data_folder();
  for (const auto& [name, edges] :
       {std::pair{"fork", "6154"}, std::pair{"comb", "579"}, std::pair{"stars", "791"}}) {
    const std::string pair = data + "/" + name;
    const Ran ran = run("oplus sum '" + pair + "_part1.dat' '" + pair +
                        "_part2.dat' --engine rca --stats -o s.wkt");
    EXPECT_TRUE(has(ran.err, "arrangement edges: " + std::string(edges) + "\n"));
  }
}

}  // namespace
}  // namespace oplus
