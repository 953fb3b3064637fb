// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "properties/runner/source_tree.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/reading.hpp"
#include "tests/checked/cli/page_text.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

namespace fs = std::filesystem;

const fs::path examples = source_root() / "docs/examples";

class Examples : public Shell {
 protected:
  Ran run_example(const std::string& name) const {
    return run("bash '" + (examples / name / "run").string() + "'");
  }
};

TEST_F(Examples, draw_their_pictures) {
  const std::string page = text_of_file(examples / "README.md");
  std::size_t pictures = 0, folders = 0;
  for (const auto& folder : fs::directory_iterator(examples)) {
    // The nesting needs the Python package: nesting_test.py.
    if (!fs::exists(folder.path() / "run") || folder.path().filename() == "nesting") continue;
    ++folders;
    const std::string name = folder.path().filename().string();
    const Ran ran = run_example(name);
    ASSERT_EQ(ran.exit_code, 0) << name << ran.err;
    EXPECT_EQ(ran.out + ran.err, "") << name;
    for (const auto& file : fs::directory_iterator(folder)) {
      if (file.path().extension() != ".svg") continue;
      ++pictures;
      const std::string picture = file.path().filename().string();
      EXPECT_TRUE(content(picture) == text_of_file(file.path()))
          << file.path() << " is out of date";
      EXPECT_NE(page.find("](" + name + "/" + picture + ")"), std::string::npos) << picture;
    }
  }
  EXPECT_EQ(folders, 3U);
  EXPECT_EQ(pictures, 6U);
}

/// Each command of the page is in a script, and each link exists.
TEST_F(Examples, are_what_their_page_says) {
  const std::string page = text_of_file(examples / "README.md");
  std::string scripts;
  for (const std::string name : {"robot", "no_fit", "nesting", "offset"})
    scripts += text_of_file(examples / name / "run");
  const std::vector<std::string> commands = commands_of(page);
  EXPECT_EQ(commands.size(), 8U);
  for (const std::string& command : commands)
    EXPECT_NE(scripts.find("\n" + command + "\n"), std::string::npos) << command;
  for (const std::string& link : found(page, "\\]\\(([^)]+)\\)"))
    EXPECT_TRUE(fs::exists(examples / link)) << link;
}

/// By the definition: P and -Q + x have no common interior point for any x on the path. Between two
/// points in which the path meets the convolution the answer is the same for all x.
TEST_F(Examples, the_robot_meets_nothing_on_its_path) {
  const Region obstacles = read_region_file((examples / "robot/obstacles.wkt").string()).region;
  const Region robot = read_region_file((examples / "robot/robot.wkt").string()).region;
  const PlanarSet path = read_sum_file((examples / "robot/path.wkt").string()).sum;
  ASSERT_EQ(path.dangling_edges.size(), 5U);
  std::vector<Segment> all = path.dangling_edges;
  for (const ConvolutionSegment& s : convolution(obstacles, reflected(robot)))
    all.push_back(s.segment);
  std::size_t pieces = 0;
  const std::vector<std::vector<Segment>> cut = cut_at_intersections(all);
  for (std::size_t i = 0; i < path.dangling_edges.size(); ++i) {
    for (const Segment& piece : cut.at(i)) {
      ++pieces;
      for (const Point& x : {piece.source, midpoint(piece.source, piece.target), piece.target})
        EXPECT_FALSE(interiors_meet(obstacles, translated(robot, x))) << x.x << ' ' << x.y;
    }
  }
  EXPECT_GT(pieces, 8U);
}

TEST_F(Examples, the_door_is_an_edge_that_only_the_open_sum_has) {
  ASSERT_EQ(run_example("robot").exit_code, 0);
  const auto door = nlohmann::json::parse(content("door.json"));
  EXPECT_EQ(door.at("equal"), false);
  EXPECT_EQ(door.at("first").at("dangling_edges"), 1);
  EXPECT_EQ(door.at("second").at("dangling_edges"), 0);
  ASSERT_EQ(run_example("no_fit").exit_code, 0);
  EXPECT_NE(content("no_fit.wkt").find("POINT (1 2)"), std::string::npos);
  ASSERT_EQ(run_example("offset").exit_code, 0);
  EXPECT_NE(content("around.wkt").find("LINESTRING (8 5, 8 8.4), POINT (3 3)"), std::string::npos);
}

}  // namespace
}  // namespace oplus
