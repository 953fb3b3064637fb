// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "reference/families/family.hpp"

namespace oplus {
namespace {

TEST(Islands, make_sums_with_islands_in_holes_exact_fits_and_filled_moats) {
  const Family& family = *find_family("islands");
  std::size_t with_islands = 0;
  std::size_t with_exact_fits = 0;
  std::size_t with_filled_moats = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Summands summands = generate(family, 3, seed);
    const MinkowskiSum open = sum_by_winding_numbers(summands.p, summands.q, Boundary::open).sum;
    with_islands += open.outer.size() > 1;
    with_exact_fits += !open.dangling_edges.empty() || !open.isolated_vertices.empty();
    with_filled_moats += open.outer.size() < summands.p.components.size();
  }
  EXPECT_GE(with_islands, 10u);
  EXPECT_GE(with_exact_fits, 20u);
  EXPECT_GE(with_filled_moats, 10u);
}

}  // namespace
}  // namespace oplus
