// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class OperationCommands : public Shell {
 protected:
  OperationCommands() {
    put("bin.wkt", "POLYGON ((0 0, 100 0, 100 100, 0 100, 0 0))");
    put("part.wkt", "POLYGON ((0 0, 10 0, 10 100, 0 100, 0 0))");
    put("free.dat", "0\n1\n4\n0 0\n0 9\n9 9\n9 0\n");
  }
};

TEST_F(OperationCommands, take_every_engine) {
  for (const std::string engine : {"slide", "rca", "loops", "winding", "oracle"})
    expect_output("oplus ifp bin.wkt part.wkt --engine " + engine,
                  "GEOMETRYCOLLECTION (LINESTRING (0 0, 90 0))\n");
}

TEST_F(OperationCommands, draw_their_result) {
  expect_output("oplus ifp bin.wkt part.wkt --svg ifp.svg -o ifp.wkt", "");
  EXPECT_TRUE(has(content("ifp.svg"), "ifp P Q"));
}

/// What no format holds has a complement that one does.
TEST_F(OperationCommands, name_the_complement_of_what_cannot_be_written) {
  put("slot.dat", "0\n1\n8\n0 0\n0 9\n9 9\n9 6\n6 6\n6 3\n9 3\n9 0\n");
  put("part.wkt", "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))");
  for (const std::string format : {"wkt", "dat", "geojson", "wkb"})
    for (const std::string options : {"", " --grid 1"})
      expect_refusal(
          "oplus ifp slot.dat part.wkt --format " + format + options,
          "write its complement: with C, which `oplus complement P` writes, that of sum P Q --open is "
          "ifp C -Q, that of nfp P Q is ifp C Q, and that of ifp P Q is nfp C Q");
  expect_output(
      "oplus complement slot.dat | oplus nfp - part.wkt",
      "GEOMETRYCOLLECTION (POLYGON ((-3 -3, 9 -3, 9 9, -3 9, -3 -3)), LINESTRING (6 3, 9 3))\n");
  // The same of a sum, and of nfp.
  put("room.dat", "0\n1\n4\n0 0\n0 3\n5 3\n5 0\n");
  const std::string where_it_fits = run("oplus complement room.dat | oplus ifp - part.wkt").out;
  EXPECT_EQ(where_it_fits, "GEOMETRYCOLLECTION (LINESTRING (0 0, 2 0))\n");
  expect_refusal("oplus nfp room.dat part.wkt", "that of nfp P Q is ifp C Q");
  expect_refusal("oplus reflect part.wkt | oplus sum room.dat - --open",
                 "that of sum P Q --open is ifp C -Q");
}

TEST_F(OperationCommands, refuse_what_they_cannot_do) {
  expect_refusal("oplus ifp bin.wkt", "Q");
  expect_refusal("oplus ifp bin.wkt missing.wkt", "missing.wkt");
  expect_refusal("oplus complement bin.wkt", "only .dat");
  expect_refusal("oplus complement bin.wkt -o out.wkt", "only .dat");
  expect_refusal("oplus ifp bin.wkt bin.wkt --format dat", ".dat cannot hold");
  expect_refusal("oplus reflect free.dat", "only .dat");
  expect_refusal("oplus sum free.dat bin.wkt --format dat --origins o.json", "bounded");
  expect_refusal("oplus verify free.dat bin.wkt bin.wkt",
                 "outer chain of component 1 is missing, so the region is unbounded");
}

}  // namespace
}  // namespace oplus
