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
  PlanarSet result(const std::string& command) const {
    const Ran ran = run(command, 0);
    return canonical_sum(read_region(ran.out, "result").region);
  }
};

/// On the boundary of the no-fit polygon and inside the inner-fit polygon, Q is as far away as it is to be, and at
/// most the error farther somewhere.
TEST_F(DistanceCommands, spacing_is_on_the_safe_side) {
  put("p.wkt", "POLYGON ((0 0, 8 0, 8 6, 0 6, 0 0), (2 2, 2 4, 4 4, 4 2, 2 2))");
  put("on.wkt", "POLYGON ((5 5, 7 5, 7 7, 5 7, 5 5))");
  put("bin.dat", "0\n1\n4\n0 0\n0 9\n9 9\n9 0\n");
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

}  // namespace
}  // namespace oplus
