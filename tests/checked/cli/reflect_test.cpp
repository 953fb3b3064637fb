// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Reflect : public Shell {
 protected:
  Reflect() { put("l.wkt", "POLYGON ((0 0, 3 0, 3 1, 1 1, 1 1/3, 0 2.5, 0 0))"); }
};

TEST_F(Reflect, takes_each_point_to_its_opposite) {
  expect_output("oplus reflect l.wkt --quiet",
                "POLYGON ((0 0, -3 0, -3 -1, -1 -1, -1 -1/3, 0 -2.5, 0 0))\n");
  put("turned.wkt", "POLYGON ((0 0, -3 0, -3 -1, -1 -1, -1 -1/3, 0 -2.5, 0 0))");
  EXPECT_EQ(run("oplus reflect l.wkt | oplus compare - turned.wkt").exit_code, 0);
}

TEST_F(Reflect, twice_gives_the_same_region_in_every_format) {
  for (const std::string format : {"wkt", "dat", "geojson"})
    expect_output("oplus --quiet reflect l.wkt --format " + format +
                      " | oplus --quiet reflect - -o twice." + format + " && oplus compare twice." +
                      format + " l.wkt",
                  "equal\n");
}

TEST_F(Reflect, takes_the_ending_of_a_file_in_capitals_too) {
  expect_output(
      "oplus --quiet reflect l.wkt -o L.GeoJSON && "
      "oplus --quiet reflect L.GeoJSON -o L.WKT && cat L.WKT",
      content("l.wkt") + "\n");
}

TEST_F(Reflect, rounds_with_digits) {
  const Ran ran = run("oplus reflect l.wkt --digits 1");
  EXPECT_EQ(ran.out, "POLYGON ((-3 -1, -1 -1, -1 -0.3, 0 -2.5, 0 0, -3 0, -3 -1))\n");
  EXPECT_TRUE(has(ran.err, "rounded to multiples of 0.1, "));
}

TEST_F(Reflect, gives_the_no_fit_polygon) {
  put("square.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  put("no_fit.wkt", "POLYGON ((-2 -2, 2 -2, 2 2, -2 2, -2 -2))");
  expect_output("oplus reflect square.wkt | oplus sum square.wkt - | oplus compare - no_fit.wkt",
                "equal\n");
}

TEST_F(Reflect, refuses_what_it_cannot_do) {
  expect_refusal("oplus reflect", "R");
  expect_refusal("oplus reflect missing.wkt", "missing.wkt");
  expect_refusal("oplus reflect l.wkt -o out.txt", "out.txt");
  expect_refusal("oplus reflect l.wkt >/dev/full", "standard output");
}

}  // namespace
}  // namespace oplus
