// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"
#include "tests/reference/pictures/parsed_picture.hpp"

namespace oplus {
namespace {

class Draw : public ShellWithRegions {
 protected:
  Draw() { put("<odd> & \xff name.wkt", "POLYGON EMPTY"); }
};

TEST_F(Draw, has_a_panel_per_file) {
  expect_output("oplus draw frame.wkt triangle.dat *odd* - -o all.svg <triangle.dat", "");
  std::set<std::string> titles;
  for (const auto& panel : groups(parsed(content("all.svg")), "panel"))
    titles.insert(panel.get<std::string>("text"));
  EXPECT_EQ(titles, (std::set<std::string>{"frame.wkt", "triangle.dat", "<odd> & ? name.wkt",
                                           "standard input"}));
}

TEST_F(Draw, draws_together_what_is_told_apart_by_its_name) {
  put("slit.wkt",
      "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)), LINESTRING (1 2, 3 2), POINT (2 3))");
  put("way.wkt", "GEOMETRYCOLLECTION (LINESTRING (5 0, 5 4))");
  expect_output("oplus draw slit.wkt frame.wkt triangle.dat way.wkt --together -o all.svg", "");
  const std::string svg = content("all.svg");
  EXPECT_EQ(groups(parsed(svg), "panel").size(), 1U);
  for (const std::string name : {">slit<", ">dangling edges of slit<",
                                 ">isolated vertices of slit<", ">frame<", ">triangle<", ">way<"})
    EXPECT_TRUE(has(svg, name));
  EXPECT_EQ(svg.find("edges of frame"), std::string::npos);
  // Of the first, "sum" is a layer's kind, and lies lowest.
  EXPECT_LT(svg.find("class=\"sum\""), svg.find("class=\"summand-p\""));
  expect_refusal("oplus draw frame.wkt triangle.dat --together --view faces -o a.svg", "--view");
}

TEST_F(Draw, writes_to_standard_output) {
  EXPECT_EQ(run("oplus draw frame.wkt -o -").out.substr(0, 5), "<svg ");
  expect_output("oplus draw frame.wkt -o /dev/null", "");
  expect_output("oplus draw frame.wkt -o ALL.SVG", "");
}

TEST_F(Draw, refuses_what_cannot_be_drawn) {
  expect_refusal("oplus draw frame.wkt", "--output");
  expect_refusal("oplus draw -o all.svg", "FILE");
  expect_refusal("oplus draw frame.wkt missing.wkt -o all.svg", "missing.wkt");
  expect_refusal("oplus draw frame.wkt -o missing/all.svg", "missing");
  expect_refusal("oplus draw frame.wkt -o all.png", "FILE.svg");
  expect_refusal("oplus sum frame.wkt triangle.dat --svg all", "FILE.svg");
  expect_refusal("oplus draw - - -o all.svg <frame.wkt", "standard input");
}

TEST_F(Draw, views_are_drawn_of_any_two_regions) {
  for (const std::string view : {"fiber-grid", "cycles", "faces", "loops", "winding", "original"}) {
    for (const std::string q : {"triangle.dat", "'<odd> & \xff name.wkt'"}) {
      run("oplus draw frame.wkt " + q + " --view " + view + " -o view.svg", 0);
      EXPECT_EQ(content("view.svg").substr(0, 5), "<svg ");
    }
  }
}

TEST_F(Draw, takes_placements_exactly) {
  const auto title = [&](const std::string& at) {
    const Ran ran =
        run("oplus draw frame.wkt - --view placement --at " + at + " -o - <triangle.dat", 0);
    const std::size_t begin = ran.out.find(">x = ") + 1;
    return ran.out.substr(begin, ran.out.find('<', begin) - begin);
  };
  EXPECT_EQ(title("1/3,2.5"), "x = (1/3, 2.5): the interiors meet");
  EXPECT_EQ(title("-1,-2e-1"), "x = (-1, -0.2): the interiors do not meet");
}

TEST_F(Draw, refuses_views_that_it_cannot_draw) {
  const std::string pair = "oplus draw frame.wkt triangle.dat -o view.svg ";
  expect_refusal(pair + "--view nothing", "fiber-grid");
  expect_refusal(pair + "--view ''", "there is no view");
  expect_refusal("oplus draw frame.wkt --view loops -o view.svg", "two files");
  expect_refusal("oplus draw frame.wkt frame.wkt frame.wkt --view loops -o view.svg", "two files");
  expect_refusal(pair + "--at 1,2", "--view placement");
  expect_refusal(pair + "--view loops --at 1,2", "takes no --at");
  expect_refusal(pair + "--view placement", "needs --at");
  for (const std::string at : {"1", "1,", ",1", "1,2,3", "'1;2'", "1/0,2", "x,y", "'1,2)'", "''",
                               ",", "1e999999999,1", "0x1,1", "$'1\\n,2'"})
    expect_refusal(pair + "--view placement --at " + at, "--at");
  put("line.wkt", "GEOMETRYCOLLECTION (LINESTRING (0 0, 1 1))");
  expect_refusal("oplus draw frame.wkt line.wkt --view loops -o view.svg", "line.wkt");
  expect_refusal(pair + "--view placement --at 1,2 -o missing/view.svg", "");
}

}  // namespace
}  // namespace oplus
