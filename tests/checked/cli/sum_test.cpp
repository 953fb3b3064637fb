// SPDX-License-Identifier: GPL-3.0-or-later
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
