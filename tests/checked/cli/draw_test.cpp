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

TEST_F(Draw, views_are_drawn_of_any_two_regions) {
  for (const std::string view : {"fiber-grid", "cycles", "faces", "loops", "winding", "original"}) {
    for (const std::string q : {"triangle.dat", "'<odd> & \xff name.wkt'"}) {
      run("oplus draw frame.wkt " + q + " --view " + view + " -o view.svg", 0);
      EXPECT_EQ(content("view.svg").substr(0, 5), "<svg ");
    }
  }
}

}  // namespace
}  // namespace oplus
