// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Reflect : public Shell {
 protected:
  Reflect() { put("l.wkt", "POLYGON ((0 0, 3 0, 3 1, 1 1, 1 1/3, 0 2.5, 0 0))"); }
};

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

TEST_F(Reflect, refuses_what_it_cannot_do) {
  expect_refusal("oplus reflect", "R");
  expect_refusal("oplus reflect missing.wkt", "missing.wkt");
  expect_refusal("oplus reflect l.wkt -o out.txt", "out.txt");
  expect_refusal("oplus reflect l.wkt >/dev/full", "standard output");
}

}  // namespace
}  // namespace oplus
