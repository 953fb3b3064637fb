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

TEST_F(ClosedSets, are_summed_in_wkt_and_geojson) {
  const std::string swept = "POLYGON ((0 0, 5 0, 5 4, 4 4, 4 1, 0 1, 0 0))\n";
  expect_output("oplus sum line.wkt square.wkt", swept);
  expect_output("oplus sum square.wkt line.json", swept);
  expect_output("oplus sum line.wkt square.wkt --open --engine rca", swept);
  expect_output("oplus sum mixed.json square.wkt",
                "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((5 5, 6 5, 6 6, 5 6, 5 5)))\n");
  expect_output(
      "echo 'MULTIPOINT(1 1,(2 2))' | oplus sum - mixed.json",
      "GEOMETRYCOLLECTION (MULTIPOLYGON (((2 2, 3 2, 3 3, 2 3, 2 2)), ((1 1, 2 1, 2 2, 1 2, 1 1))), POINT (6 6), POINT (7 7))\n");
  expect_output("oplus sum line.json line.wkt --format geojson | oplus compare - lines.wkt",
                "equal\n");
}

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

TEST_F(ClosedSets, are_taken_by_operations) {
  put("bin.wkt", "POLYGON((0 0,9 0,9 2,4 2,4 4,0 4,0 0))");
  const auto line = [](const std::string& vertices) {
    return "<(echo 'LINESTRING(" + vertices + ")')";
  };
  expect_output("oplus ifp bin.wkt " + line("0 0,6 0"), "POLYGON ((0 0, 3 0, 3 2, 0 2, 0 0))\n");
  expect_output("oplus ifp bin.wkt " + line("0 0,9 0"),
                "GEOMETRYCOLLECTION (LINESTRING (0 0, 0 2))\n");
  expect_output("oplus ifp bin.wkt <(echo 'MULTIPOINT(0 0,9 0,0 4)')",
                "GEOMETRYCOLLECTION (POINT (0 0))\n");
  expect_output("oplus erode bin.wkt " + line("0 0,9 0"), "POLYGON EMPTY\n");
  expect_output("oplus open bin.wkt " + line("0 0,6 0"), "POLYGON ((0 0, 9 0, 9 2, 0 2, 0 0))\n");
  expect_output(
      "oplus close <(echo 'MULTIPOLYGON(((0 0,1 0,1 1,0 1,0 0)),((2 0,3 0,3 1,2 1,2 0)))') " +
          line("0 0,1 0"),
      "POLYGON ((0 0, 3 0, 3 1, 0 1, 0 0))\n");
  expect_output("oplus nfp line.wkt square.wkt",
                run("oplus reflect square.wkt | oplus sum line.wkt - --open").out);
  expect_output("oplus nfp square.wkt line.json --svg nfp.svg -o nfp.wkt", "");
  EXPECT_TRUE(has(content("nfp.svg"), "Q: 2 segments"));
  const Ran ran = run("oplus nfp line.wkt line.json");
  EXPECT_EQ(ran.out, "POLYGON EMPTY\n");
  EXPECT_TRUE(has(ran.err, "neither set has inner points, so they never overlap"));
}

TEST_F(ClosedSets, are_reflected) {
  expect_output("oplus reflect line.json",
                "GEOMETRYCOLLECTION (LINESTRING (-4 -3, -4 0), LINESTRING (-4 0, 0 0))\n");
  // A vertex that is repeated is no point beside the line.
  expect_output("oplus reflect line.wkt", run("oplus reflect line.json").out);
  expect_output("echo 'LINESTRING(1 2,1 2)' | oplus reflect -",
                "GEOMETRYCOLLECTION (POINT (-1 -2))\n");
  expect_output("oplus reflect mixed.json",
                "GEOMETRYCOLLECTION (POLYGON ((-1 -1, 0 -1, 0 0, -1 0, -1 -1)), POINT (-5 -5), "
                "POINT (-1 -1))\n");
  // Of an open set, whose edges are in its complement.
  put("slit.wkt", "GEOMETRYCOLLECTION(POLYGON((0 0,4 0,4 4,0 4,0 0)),LINESTRING(1.4 2,3 2))");
  expect_output("oplus reflect slit.wkt",
                "GEOMETRYCOLLECTION (POLYGON ((-4 -4, 0 -4, 0 0, -4 0, -4 -4)), LINESTRING (-3 -2, "
                "-1.4 -2))\n");
  expect_output("oplus --quiet reflect slit.wkt --open --grid 1",
                "GEOMETRYCOLLECTION (POLYGON ((-4 -4, 0 -4, 0 0, -4 0, -4 -4)), LINESTRING (-3 -2, "
                "-1 -2))\n");
  put("gap.wkt", "MULTIPOLYGON(((0 0,2 0,2 2,0 2,0 0)),((2.2 0,4 0,4 2,2.2 2,2.2 0)))");
  expect_output("oplus --quiet reflect gap.wkt --open --grid 1",
                "GEOMETRYCOLLECTION (POLYGON ((-4 -2, 0 -2, 0 0, -4 0, -4 -2)), LINESTRING (-2 -2, "
                "-2 0))\n");
}

TEST_F(ClosedSets, refuse_bad_input_in_one_line) {
  const auto refused = [&](const std::string& text, const std::string& part) {
    put("bad.wkt", text);
    expect_refusal("oplus sum bad.wkt square.wkt -o sum.wkt", part);
  };
  refused("LINESTRING(1 1)", "line string 1 has 1 vertex; expected at least 2");
  refused("LINESTRING(1 1,2)", "y of vertex 2 of line string 1");
  refused("POINT(1)", "y of point 1");
  refused("MULTIPOINT(1 1,2 x)", "'x'");
  refused("CIRCLE(1 1)", "GEOMETRYCOLLECTION");
  refused("GEOMETRYCOLLECTION(POINT(1 1),POLYGON((0 0,2 2,2 0,0 2,0 0)))", "cross");
  refused("GEOMETRYCOLLECTION(POINT(1 1)", "end of the input");
}

}  // namespace
}  // namespace oplus
