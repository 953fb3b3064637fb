// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/oplus/engines.hpp"

#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion frame =
    polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
const ValidRegion bar = polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}});

TEST(Engine, is_found_by_its_name) {
  EXPECT_EQ(engine_names().front(), "slide");
  EXPECT_NE(engine("rca"), engine("loops"));
  try {
    engine("none");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find("unknown engine none; expected one of slide, "), 0U)
        << error.what();
  }
}

TEST(Engines, compute_the_same) {
  const ValidSet both(bar, {{{2, 1}, {2, 5}}});
  const PreparedRegion prepared(frame);
  for (const std::string& name : engine_names()) {
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      const SumOptions options = {.boundary = boundary, .engine = engine(name)};
      EXPECT_EQ(minkowski_sum(frame, -bar, options),
                minkowski_sum(frame, -bar, {.boundary = boundary}))
          << name;
    }
    const SumOptions by_name = {.engine = engine(name)};
    EXPECT_EQ(minkowski_sum(prepared, bar, by_name), minkowski_sum(frame, bar)) << name;
    EXPECT_EQ(minkowski_sum(both, bar, by_name), minkowski_sum(both, bar)) << name;
    EXPECT_EQ(ifp(frame, bar, by_name), ifp(frame, bar)) << name;
  }
}

}  // namespace
}  // namespace oplus
