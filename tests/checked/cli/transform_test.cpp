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

TEST_F(Transform, says_the_exact_angle_of_a_rotation) {
  const Ran ran = run("oplus transform l.wkt --rotate 30 --angle-error 0.001", 0);
  EXPECT_TRUE(has(ran.err,
                  "rotated exactly by the angle with cosine 40545/46817 and sine 23408/46817, "
                  "29.99929342726 degrees"))
      << ran.err;
  EXPECT_TRUE(has(run("oplus transform l.wkt --rotate 4/5,3/5").err, "36.869897645844 degrees"));
  EXPECT_EQ(run("oplus transform l.wkt --rotate 180").err, "");
}

TEST_F(Transform, refuses_what_it_cannot_do) {
  put("outside.dat", "0\n1\n4\n0 0\n0 1\n1 1\n1 0\n");
  expect_refusal("oplus transform outside.dat --scale 2 -o large.wkt", "unbounded");
  expect_refusal("oplus transform set.wkt --reflect y -o set.dat", ".dat cannot hold");
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
