// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/fitting_pairs.hpp"

#include <gtest/gtest.h>

#include "reference/chains/frame.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/oracle/operations_by_definition.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(FittingPair, is_valid_and_unbounded_where_its_kind_says_so) {
  for (const char* family : {"grid", "tight", "holes", "components", "islands"}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Summands summands = generate(*find_family(family), 3, seed);
      for (std::size_t kind = 0; kind < fitting_kinds; ++kind) {
        for (const bool second : {false, true}) {
          const auto [how, pair] = fitting_pair(summands, kind, second);
          EXPECT_FALSE(find_defect(framed(pair.p, 1))) << family << ' ' << seed << ' ' << how;
          EXPECT_FALSE(find_defect(framed(pair.q, 1))) << family << ' ' << seed << ' ' << how;
          EXPECT_FALSE(how.empty());
          if (kind == 0 || kind == 3) {
            EXPECT_FALSE(is_unbounded(pair.p));
          }
          EXPECT_EQ(is_unbounded(pair.q), kind == 4);
          if (kind == 4) {
            EXPECT_EQ(is_unbounded(pair.p), second);
          }
        }
      }
    }
  }
}

TEST(FittingPair, fits_where_it_should) {
  const Region frame = holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)});
  const Region square = polygon(box(0, 0, 2, 2));
  const auto ifp = find_defined_operation("ifp")->compute;
  const Summands in_the_hole = fitting_pair({frame, square}, 1).pair;
  EXPECT_EQ(ifp(in_the_hole.p, in_the_hole.q).isolated_vertices, (std::vector<Point>{{3, 3}}));
  const Summands of_both = fitting_pair({frame, square}, 4, true).pair;
  EXPECT_EQ(ifp(of_both.p, of_both.q).isolated_vertices, (std::vector<Point>{{-3, -3}}));
  const Summands around = fitting_pair({frame, square}, 2).pair;
  EXPECT_TRUE(ifp(around.p, around.q).is_unbounded);
  const Summands along = fitting_pair({frame, square}, 3, true).pair;
  EXPECT_EQ(ifp(along.p, along.q).dangling_edges,
            (std::vector<Segment>{{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}}));
  const Summands copies = fitting_pair({frame, square}, 3).pair;
  EXPECT_EQ(ifp(copies.p, copies.q).isolated_vertices,
            (std::vector<Point>{{0, 0}, {4, 0}, {4, 4}}));
}

}  // namespace
}  // namespace oplus
