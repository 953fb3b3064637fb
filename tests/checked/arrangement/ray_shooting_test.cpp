// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/ray_shooting.hpp"

#include <gtest/gtest.h>

#include "checked/arrangement/winding_numbers.hpp"
#include "properties/compare/corpus.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(RayShooting, beside_every_edge_of_every_row_is_the_winding_number_of_the_face) {
  std::size_t positive = 0;
  for (const CorpusPair& row : corpus()) {
    const std::vector<ConvolutionSegment> full = convolution(row.p, row.q);
    const RayShooting rays(segments(full));
    const ConvolutionArrangement a(full);
    const std::vector<int> of_faces = winding_numbers(a);
    for (ConvolutionArrangement::Halfedge h = 0; h < 2 * a.edge_count(); ++h) {
      const int expected = of_faces[a.face(ConvolutionArrangement::twin(h))];
      EXPECT_EQ(rays.winding_number_right_of(a.geometry(h)), expected) << row.name;
      positive += expected > 1;
    }
  }
  EXPECT_GT(positive, 20u);
}

TEST(RayShooting, beside_an_edge_that_crosses_a_segment_in_its_middle_is_beside_the_upper_part) {
  const RayShooting rays(edges(box(0, 0, 2, 2)));
  EXPECT_EQ(rays.winding_number_right_of({{3, 0}, {1, 2}}), 1);
}

}  // namespace
}  // namespace oplus
