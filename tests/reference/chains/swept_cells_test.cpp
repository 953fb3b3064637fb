// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/swept_cells.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

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

TEST(SweptCells, are_those_of_all_pairs) {
  Random random(25);
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Segment> segments = random_segments(random);
    const Cells swept = swept_cells(segments), expected = cells(segments);
    const std::string of = testing::PrintToString(segments);
    ASSERT_EQ(swept.vertices, expected.vertices) << of;
    ASSERT_EQ(swept.faces, expected.faces) << of;
    ASSERT_EQ(swept.edges.size(), expected.edges.size()) << of;
    for (std::size_t e = 0; e < swept.edges.size(); ++e) {
      const Cells::Edge &a = swept.edges[e], &b = expected.edges[e];
      ASSERT_EQ(a.segment, b.segment) << of;
      ASSERT_EQ(std::pair(a.source, a.target), std::pair(b.source, b.target)) << of;
      ASSERT_EQ(std::pair(a.left_face, a.right_face), std::pair(b.left_face, b.right_face)) << of;
    }
  }
}

}  // namespace
}  // namespace oplus
