// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Disc : public Shell {};

TEST_F(Disc, says_how_many_vertices_it_has) {
  const Ran ran = run("oplus disc --radius 100 --error 1 --outside -o disc.dat", 0);
  EXPECT_TRUE(has(ran.err, "a polygon of 24 vertices around the disc")) << ran.err;
  EXPECT_EQ(content("disc.dat").substr(0, 3), "24\n");
}

TEST_F(Disc, is_rounded_to_its_own_side_of_the_circle) {
  expect_output(
      "oplus --quiet disc --radius 1 --outside --error 0.1 --digits 1",
      run("oplus --quiet disc --radius 1 --outside --error 0.1 --digits 1 --side contain").out);
  expect_output(
      "oplus --quiet disc --radius 3 --inside --error 0.1 --grid 1/4",
      run("oplus --quiet disc --radius 3 --inside --error 0.1 --grid 1/4 --side contained").out);
}

TEST_F(Disc, refuses_what_it_cannot_do) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "--radius"},
      {"--radius 1 --inside", "--error"},
      {"--error 1 --inside", "--radius"},
      {"--radius 1 --error 0.1", "--inside and --outside"},
      {"--radius 1 --error 0.1 --inside --outside", "--inside and --outside"},
      {"--radius 0 --error 0.1 --inside", "the radius is zero"},
      {"--radius -1 --error 0.1 --outside", "the radius is negative"},
      {"--radius 1 --error 0 --inside", "the error is zero"},
      {"--radius 1 --error -1e-3 --inside", "the error is negative"},
      {"--radius 1 --error 1e-13 --inside", "more than 1000000 vertices"},
      {"--radius 1e4000 --error 1e-4000 --outside", "more than 1000000 vertices"},
      {"--radius big --error 1 --inside", "--radius"},
      {"--radius 1 --error 1/0 --inside -o disc.wkt", "--error"},
      {"--radius 1 --error 0.1 --inside -o disc.txt", "disc.txt"},
      {"--radius 1 --error 0.1 --inside extra", "extra"}};
  for (const auto& [options, part] : cases) expect_refusal("oplus disc " + options, part);
}

}  // namespace
}  // namespace oplus
