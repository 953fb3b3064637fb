// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference/definitions/tangent_set.hpp"
#include "reference/families/family.hpp"

namespace oplus {
namespace {

std::size_t reflex_count(const Chain& chain) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Corner corner{chain[i] - chain[previous(i, chain.size())],
                        chain[next(i, chain.size())] - chain[i]};
    count += is_reflex(corner) ? 1 : 0;
  }
  return count;
}

TEST(CombFamily, has_n_teeth_and_a_convex_polygon) {
  const Family& family = *find_family("comb");
  for (const std::size_t teeth : {1u, 2u, 4u, 25u}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Summands summands = generate(family, teeth, seed);
      const Chain& comb = summands.p.components[0].outer;
      EXPECT_EQ(comb.size(), 2 * teeth + 3);
      // Between two teeth there is a reflex vertex; the first and the last valley may be convex.
      EXPECT_GE(reflex_count(comb), teeth - 1);
      EXPECT_LE(reflex_count(comb), teeth + 1);
      EXPECT_EQ(reflex_count(summands.q.components[0].outer), 0u);
      EXPECT_LE(vertex_count(summands.q), 8u);
    }
  }
}

}  // namespace
}  // namespace oplus
