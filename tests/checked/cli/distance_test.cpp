// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/distance/distance.hpp"

#include "checked/operations/complement.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/reading.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class DistanceCommands : public Shell {
 protected:
  DistanceCommands() {
    put("p.wkt", "POLYGON ((0 0, 8 0, 8 6, 0 6, 0 0), (2 2, 2 4, 4 4, 4 2, 2 2))");
    put("far.wkt", "POLYGON ((11 10, 13 10, 13 12, 11 12, 11 10))");
    put("on.wkt", "POLYGON ((5 5, 7 5, 7 7, 5 7, 5 5))");
    put("bin.dat", "0\n1\n4\n0 0\n0 9\n9 9\n9 0\n");
    put("empty.wkt", "POLYGON EMPTY");
  }

  PlanarSet result(const std::string& command) const {
    const Ran ran = run(command, 0);
    return canonical_sum(read_region(ran.out, "result").region);
  }
};

TEST_F(DistanceCommands, answer_in_words_and_in_json) {
  expect_output("oplus distance p.wkt far.wkt",
                "distance: 5\nsquared: 25\nnearest: (8, 6) of P and (11, 10) of Q\n");
  expect_output("oplus depth p.wkt on.wkt",
                "depth: 1\nsquared: 1\nmove: (0, 1)\ncontact: (5, 6)\n");
  expect_output("oplus depth p.wkt far.wkt",
                "depth: 0\nsquared: 0\nmove: none, since they don't overlap\n");
  expect_output("oplus distance p.wkt - --json <far.wkt | tr -d ' \\n'",
                R"({"squared_distance":"25","distance":"5","on_p":["8","6"],"on_q":["11","10"]})");
  expect_output(
      "oplus depth p.wkt on.wkt --json | tr -d ' \\n'",
      R"({"squared_depth":"1","depth":"1","overlap":true,"move":["0","1"],"contact":["5","6"]})");
  expect_output("oplus depth p.wkt far.wkt --json | tr -d ' \\n'",
                R"({"squared_depth":"0","depth":"0","overlap":false})");
  put("near.wkt", "POLYGON ((9 7, 10 7, 10 8, 9 7))");
  expect_output("oplus distance p.wkt near.wkt | head -2", "distance: 1.41421\nsquared: 2\n");
}

TEST_F(DistanceCommands, refuse_what_has_no_answer) {
  for (const std::string command : {"oplus distance ", "oplus depth "}) {
    expect_refusal(command + "p.wkt empty.wkt", "empty.wkt: the region is empty");
    expect_refusal(command + "p.wkt", "Q");
    expect_refusal(command + "p.wkt missing.wkt", "missing.wkt");
    expect_refusal(command + "- - <p.wkt", "standard input");
    expect_refusal(command + "p.wkt far.wkt >/dev/full", "standard output");
  }
  put("large.wkt", "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))");
  expect_refusal("oplus depth bin.dat large.wkt", "Q overlaps P wherever it is moved to");
}

TEST_F(DistanceCommands, spacing_grows_q_by_a_polygon_around_the_disc) {
  run("oplus disc --radius 2 --outside --error 0.02 -o disc.wkt", 0);
  run("oplus disc --radius 2 --outside --error 0.5 -o rough.wkt", 0);
  run("oplus complement bin.dat -o bin.wkt", 0);
  for (const auto& [disc, error] :
       {std::pair<std::string, std::string>("disc", ""), {"rough", " --spacing-error 1/2"}}) {
    run("oplus sum on.wkt " + disc + ".wkt -o grown.wkt", 0);
    for (const std::string pair : {"nfp p.wkt ", "ifp bin.wkt "}) {
      const std::string plain = run("oplus " + pair + "grown.wkt").out;
      expect_output("oplus " + pair + "on.wkt --spacing 2" + error, plain);
    }
  }
  put("pair", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))\tPOLYGON ((5 5, 7 5, 7 7, 5 7, 5 5))\n");
  put("parts", content("bin.wkt") + content("on.wkt"));
  const std::string fits = run("oplus ifp bin.wkt on.wkt --spacing 2").out;
  const std::string result = "\"result\": \"" + fits.substr(0, fits.size() - 1) + "\"}\n";
  expect_output("oplus batch pair --operation ifp --spacing 2", "{\"line\": 1, " + result);
  EXPECT_TRUE(has(run("oplus batch --parts parts --operation ifp --spacing 2").out,
                  "{\"p\": 1, \"q\": 2, " + result));
}

/// On the boundary of the no-fit polygon and inside the inner-fit polygon, Q is as far away as it is to be, and at
/// most the error farther somewhere.
TEST_F(DistanceCommands, spacing_is_on_the_safe_side) {
  const Region p = read_region(content("p.wkt"), "p").region;
  const Region q = read_region(content("on.wkt"), "q").region;
  run("oplus complement bin.dat -o bin.wkt", 0);
  const Region outside = complement(read_region(content("bin.wkt"), "bin").region);
  const Rational most = Rational(202, 100) * Rational(202, 100);
  for (const auto& [command, from] :
       {std::pair<std::string, const Region&>("nfp p.wkt", p), {"ifp bin.wkt", outside}}) {
    std::size_t places = 0;
    for (const Segment& e : edges(result("oplus " + command + " on.wkt --spacing 2"))) {
      for (const Point& x : {e.source, midpoint(e.source, e.target)}) {
        const Rational squared = distance(from, translated(q, x)).squared_distance;
        EXPECT_GE(squared, 4);
        EXPECT_LE(squared, most);
        ++places;
      }
    }
    EXPECT_GE(places, 8U);
  }
}

TEST_F(DistanceCommands, spacing_is_a_distance_above_0_of_places) {
  run("oplus complement bin.dat -o bin.wkt", 0);
  put("pair", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))\tPOLYGON ((5 5, 7 5, 7 7, 5 7, 5 5))\n");
  for (const std::string command : {"oplus nfp p.wkt on.wkt ", "oplus ifp bin.wkt on.wkt ",
                                    "oplus batch pair --operation nfp "}) {
    expect_refusal(command + "--spacing 0", "--spacing takes a distance above 0, not '0'");
    expect_refusal(command + "--spacing -1", "--spacing");
    expect_refusal(command + "--spacing far", "--spacing");
    expect_refusal(command + "--spacing 1 --spacing-error 0", "--spacing-error takes a distance");
    expect_refusal(command + "--spacing-error 1", "--spacing-error is for --spacing");
  }
  expect_refusal("oplus nfp p.wkt on.wkt --spacing 1 --spacing-error 1e-20", "vertices");
  expect_refusal("oplus erode p.wkt on.wkt --spacing 1", "--spacing");
  expect_refusal("oplus batch pair --operation sum --spacing 1",
                 "--spacing is for --operation nfp and ifp");
}

}  // namespace
}  // namespace oplus
