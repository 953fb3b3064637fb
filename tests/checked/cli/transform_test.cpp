// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Transform : public Shell {
 protected:
  Transform() {
    put("l.wkt", "POLYGON ((0 0, 3 0, 3 1, 1 1, 1 2, 0 2, 0 0))");
    put("set.wkt",
        "GEOMETRYCOLLECTION (POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0), (0 1, 1 1.5, 1 0.5, 0 1)), "
        "LINESTRING (4 0, 5 0), POINT (7 1))");
  }
};

TEST_F(Transform, does_what_its_options_say) {
  const std::pair<std::string, std::string> cases[] = {
      {"--translate 1,-0.5", "POLYGON ((1 -0.5, 4 -0.5, 4 0.5, 2 0.5, 2 1.5, 1 1.5, 1 -0.5))\n"},
      {"--translate -1/3,1e1",
       "POLYGON ((-1/3 10, 8/3 10, 8/3 11, 2/3 11, 2/3 12, -1/3 12, -1/3 10))\n"},
      {"--scale 2", "POLYGON ((0 0, 6 0, 6 2, 2 2, 2 4, 0 4, 0 0))\n"},
      {"--scale -1", "POLYGON ((-3 -1, -1 -1, -1 -2, 0 -2, 0 0, -3 0, -3 -1))\n"},
      {"--scale -1,2", "POLYGON ((-3 0, 0 0, 0 4, -1 4, -1 2, -3 2, -3 0))\n"},
      {"--rotate 90", "POLYGON ((-2 0, 0 0, 0 3, -1 3, -1 1, -2 1, -2 0))\n"},
      {"--rotate -270", "POLYGON ((-2 0, 0 0, 0 3, -1 3, -1 1, -2 1, -2 0))\n"},
      {"--rotate 4/5,3/5",
       "POLYGON ((-1.2 1.6, 0 0, 2.4 1.8, 1.8 2.6, 0.2 1.4, -0.4 2.2, -1.2 1.6))\n"},
      {"--reflect x", "POLYGON ((0 -2, 1 -2, 1 -1, 3 -1, 3 0, 0 0, 0 -2))\n"},
      {"--reflect y", "POLYGON ((-3 0, 0 0, 0 2, -1 2, -1 1, -3 1, -3 0))\n"},
      {"--reflect origin", "POLYGON ((-3 -1, -1 -1, -1 -2, 0 -2, 0 0, -3 0, -3 -1))\n"}};
  for (const auto& [options, expected] : cases)
    expect_output("oplus --quiet transform l.wkt " + options, expected);
}

TEST_F(Transform, applies_options_in_the_order_of_the_command_line) {
  expect_output("oplus transform l.wkt --translate 1,0 --scale 2 --translate -2,0",
                run("oplus transform l.wkt --scale 2").out);
  expect_output("oplus transform l.wkt --scale 2 --translate 1,0 --rotate 90 --reflect y",
                run("oplus transform l.wkt --scale 2 | oplus transform - --translate 1,0 | "
                    "oplus transform --rotate 90 - | oplus transform --reflect y -")
                    .out);
}

TEST_F(Transform, says_the_exact_angle_of_a_rotation) {
  const Ran ran = run("oplus transform l.wkt --rotate 30 --angle-error 0.001");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(has(ran.err,
                  "rotated exactly by the angle with cosine 40545/46817 and sine 23408/46817, "
                  "29.99929342726 degrees"))
      << ran.err;
  EXPECT_TRUE(has(run("oplus transform l.wkt --rotate 4/5,3/5").err, "36.869897645844 degrees"));
  EXPECT_EQ(run("oplus transform l.wkt --rotate 180").err, "");
}

TEST_F(Transform, rotates_back_exactly) {
  expect_output(
      "oplus --quiet transform l.wkt --rotate 30 | oplus --quiet transform - --rotate -30 | "
      "oplus compare - l.wkt",
      "equal\n");
}

TEST_F(Transform, takes_sums_with_dangling_edges_and_isolated_vertices) {
  expect_output(
      "oplus transform set.wkt --reflect y",
      "GEOMETRYCOLLECTION (POLYGON ((-2 0, 0 0, 0 2, -2 2, -2 0), (-1 0.5, -1 1.5, 0 1, -1 0.5)), "
      "LINESTRING (-5 0, -4 0), POINT (-7 1))\n");
  expect_output(
      "oplus transform set.wkt --reflect y | oplus transform - --reflect y | "
      "oplus compare - set.wkt",
      "equal\n");
  expect_refusal("oplus transform set.wkt --reflect y -o set.dat", ".dat cannot hold");
}

TEST_F(Transform, takes_line_strings_and_points) {
  put("path.wkt", "LINESTRING (0 0, 2 0, 2 2, 2 2)");
  expect_output("oplus transform path.wkt --rotate 90 --translate 0.5,0",
                run("oplus transform path.wkt --translate 0,-0.5 --rotate 90").out);
  EXPECT_TRUE(has(run("oplus transform path.wkt --rotate 90").out, "(0 0, 0 2)"));
  put("point.wkt", "POINT (1 2)");
  expect_output("oplus transform point.wkt --rotate 90", "GEOMETRYCOLLECTION (POINT (-2 1))\n");
}

TEST_F(Transform, rounds_line_strings_and_points_as_parts_of_the_set) {
  put("place.wkt", "GEOMETRYCOLLECTION (LINESTRING (0 0, 3 0, 4 2), POINT (9 9))");
  expect_output("oplus --quiet transform place.wkt --translate 0.3,0.3 --grid 1",
                "GEOMETRYCOLLECTION (LINESTRING (0 0, 3 0), LINESTRING (3 0, 4 2), POINT (9 9))\n");
  put("set.wkt", "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)), POINT (4.4 4))");
  expect_output("oplus --quiet transform set.wkt --scale 1 --open --grid 1",
                "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)), POINT (4 4))\n");
  expect_output("oplus --quiet transform set.wkt --scale 1 --grid 1",
                "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))\n");
}

TEST_F(Transform, takes_unbounded_regions_and_the_empty_one) {
  put("outside.dat", "0\n1\n4\n0 0\n0 1\n1 1\n1 0\n");
  expect_output(
      "oplus transform outside.dat --scale -2,2 -o large.dat && "
      "oplus complement large.dat",
      "POLYGON ((-2 0, 0 0, 0 2, -2 2, -2 0))\n");
  expect_refusal("oplus transform outside.dat --scale 2 -o large.wkt", "unbounded");
  put("empty.wkt", "POLYGON EMPTY");
  expect_output("oplus transform empty.wkt --scale 2", "POLYGON EMPTY\n");
}

TEST_F(Transform, refuses_what_it_cannot_do) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "nothing to do"},
      {"--translate 1", "not two numbers"},
      {"--translate 1,x", "--translate"},
      {"--translate 1,2,3", "--translate"},
      {"--translate", "--translate"},
      {"--scale 0", "a factor is zero"},
      {"--scale 1,0", "a factor is zero"},
      {"--scale 1/0", "--scale"},
      {"--rotate east", "--rotate"},
      {"--rotate 1/2,1/2", "don't add up to 1"},
      {"--rotate 1e5000", "--rotate"},
      {"--rotate 30 --angle-error 0", "--angle-error takes degrees above 0, not '0'"},
      {"--rotate 30 --angle-error -1", "--angle-error takes degrees above 0, not '-1'"},
      {"--rotate 30 --angle-error tiny", "--angle-error"},
      {"--angle-error 1", "--rotate"},
      {"--reflect z", "--reflect"},
      {"--rotate 30 -o out.txt", "out.txt"},
      {"--rotate 30 -o missing/out.wkt", "missing"}};
  for (const auto& [options, part] : cases)
    expect_refusal("oplus transform l.wkt " + options, part);
  expect_refusal("oplus transform --rotate 30", "R");
  expect_refusal("oplus transform missing.wkt --rotate 30", "missing.wkt");
  put("crossed.wkt", "POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))");
  expect_refusal("oplus transform crossed.wkt --rotate 30 -o out.wkt", "crossed.wkt");
}

}  // namespace
}  // namespace oplus
