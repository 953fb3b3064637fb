// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class ClosedSets : public Shell {
 protected:
  ClosedSets() {
    put("square.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))");
    put("line.wkt", "LINESTRING(0 0,4 0,4 0,4 3)");
    put("lines.wkt",
        "GEOMETRYCOLLECTION(POLYGON((4 0,8 0,8 3,4 3,4 0)),MULTILINESTRING((0 0,4 0),(8 3,8 6)))");
    put("line.json", R"({"type":"LineString","coordinates":[[0,0],[4,0],[4,3]]})");
    put("mixed.json",
        R"({"type":"GeometryCollection","geometries":[{"type":"MultiPoint","coordinates":[[1,1],[5,5]]},)"
        R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]}]})");
  }
};

TEST_F(ClosedSets, are_drawn) {
  expect_output("oplus sum line.wkt mixed.json --svg sum.svg -o sum.wkt", "");
  EXPECT_TRUE(has(content("sum.svg"), "P: 2 segments"));
  EXPECT_TRUE(has(content("sum.svg"), "Q: 4 vertices, 1 point"));
}

TEST_F(ClosedSets, have_an_empty_open_sum_without_inner_points) {
  const Ran ran = run("oplus sum line.wkt line.json --open");
  EXPECT_EQ(ran.out, "POLYGON EMPTY\n");
  EXPECT_TRUE(has(ran.err, "neither summand has inner points, so the open sum is empty"));
  EXPECT_EQ(ran.exit_code, 0);
}

TEST_F(ClosedSets, are_summed_by_every_engine_and_come_from_pipes) {
  const std::string swept = "POLYGON ((0 0, 5 0, 5 4, 4 4, 4 1, 0 1, 0 0))\n";
  expect_output("oplus sum line.wkt square.wkt --open --engine rca", swept);
  expect_output("oplus sum line.json line.wkt --format geojson | oplus compare - lines.wkt",
                "equal\n");
}

TEST_F(ClosedSets, without_inner_points_never_overlap) {
  expect_output("oplus nfp square.wkt line.json --svg nfp.svg -o nfp.wkt", "");
  EXPECT_TRUE(has(content("nfp.svg"), "Q: 2 segments"));
  const Ran ran = run("oplus nfp line.wkt line.json");
  EXPECT_EQ(ran.out, "POLYGON EMPTY\n");
  EXPECT_TRUE(has(ran.err, "neither set has inner points, so they never overlap"));
}

TEST_F(ClosedSets, refuse_what_is_for_regions) {
  for (const std::string option :
       {"--origins o.json", "--certificate c", "--stats", "--stats-json s"})
    expect_refusal("oplus sum line.wkt square.wkt -o sum.wkt " + option,
                   option.substr(0, option.find(' ')) + " is for sums of regions");
  expect_refusal("oplus sum line.wkt line.wkt -o sum.dat", ".dat cannot hold the dangling edges");
  expect_refusal("oplus verify line.wkt square.wkt square.wkt",
                 "POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION");
  for (const std::string operation : {"ifp", "erode", "open", "close"})
    expect_refusal("oplus " + operation + " line.wkt square.wkt",
                   "line.wkt:1:1: 'LINESTRING' where a geometry should be; expected POLYGON, "
                   "MULTIPOLYGON or GEOMETRYCOLLECTION");
  expect_refusal("oplus complement lines.wkt --format dat",
                 "'MULTILINESTRING' where a geometry should be; expected POLYGON or MULTIPOLYGON");
}

}  // namespace
}  // namespace oplus
