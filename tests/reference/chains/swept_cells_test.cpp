// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/swept_cells.hpp"

#include <gtest/gtest.h>

#include "reference/definitions/cut_at_intersections.hpp"
#include "tests/reference/chains/random_segments.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

TEST(SweptCells, pieces_are_those_of_all_pairs) {
  Random random(21);
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Segment> segments = random_segments(random);
    ASSERT_EQ(swept_pieces(segments), cut_at_intersections(segments))
        << testing::PrintToString(segments);
  }
}

}  // namespace
}  // namespace oplus
