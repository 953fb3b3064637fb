// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/pair_of_bytes.hpp"

#include <gtest/gtest.h>

#include <map>

#include "checked/slide/number_types.hpp"
#include "checked/slide/scaling.hpp"
#include "properties/compare/corpus.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/chains/validity.hpp"

namespace oplus {
namespace {

std::string random_bytes(Random& random) {
  std::string bytes(uniform_index(random, 60), '\0');
  for (char& byte : bytes) byte = static_cast<char>(uniform(random, 0, 255));
  return bytes;
}

/// Most bytes are a pair, always valid, with all degeneracies, in numbers on both sides of the limits of
/// slide's stages, and just there.
TEST(PairOfBytes, is_valid_and_has_all_degeneracies) {
  Random random(6);
  constexpr int cases = 600;
  int pairs = 0, holes = 0, several_components = 0, touching = 0, fractions = 0, many_edges = 0;
  std::map<std::size_t, int> bits;  // as slide counts them
  constexpr auto long_too = slide::Denominators::any;
  for (int i = 0; i < cases; ++i) {
    const std::string bytes = random_bytes(random);
    const auto pair = pair_of_bytes(bytes);
    if (!pair) continue;
    ASSERT_EQ(pair_of_bytes(bytes), pair) << i;
    ++pairs;
    const auto& [p, q] = *pair;
    for (const Region* region : {&p, &q}) {
      ASSERT_FALSE(region->components.empty()) << i;
      ASSERT_FALSE(find_defect(*region)) << i;
      for (const Component& component : region->components) {
        ASSERT_GT(sign(twice_area(component.outer)), 0) << i;
        for (const Chain& hole : component.holes) ASSERT_LT(sign(twice_area(hole)), 0) << i;
        fractions += component.outer[0].x.get_den() != 1;
      }
      holes += has_hole(*region);
      several_components += region->components.size() > 1;
      touching += !touching_points(*region).empty();
    }
    many_edges += vertex_count(p) * vertex_count(q) > 512;
    ++bits[slide::scaling_of(slide::extent_of(p, long_too), slide::extent_of(q, long_too)).bits];
  }
  EXPECT_GT(pairs, cases * 9 / 10);
  EXPECT_GT(holes, cases / 6);
  EXPECT_GT(several_components, cases / 8);
  EXPECT_GT(touching, cases / 20);
  EXPECT_GT(fractions, cases / 20);
  EXPECT_GT(many_edges, cases / 100);
  int small = 0, wide = 0, any = 0;
  for (const auto& [of_pair, times] : bits)
    (of_pair <= slide::SmallNumbers::bits  ? small
     : of_pair <= slide::WideNumbers::bits ? wide
                                           : any) += times;
  EXPECT_GT(small, cases / 10);
  EXPECT_GT(wide, cases / 10);
  EXPECT_GT(any, cases / 10);
  for (const std::size_t limit : {slide::SmallNumbers::bits, slide::WideNumbers::bits}) {
    EXPECT_TRUE(bits.contains(limit)) << limit;
    EXPECT_TRUE(bits.contains(limit + 1)) << limit;
  }
}

TEST(PairOfBytes, is_spelled_out_where_no_family_makes_it) {
  std::size_t spelled = 0;
  for (const CorpusPair& row : corpus()) {
    const auto bytes = bytes_of_pair({row.p, row.q});
    if (!bytes) continue;
    ++spelled;
    EXPECT_TRUE(pair_of_bytes(*bytes) == (Summands{row.p, row.q})) << row.name;
  }
  EXPECT_GT(spelled, 5U);
  const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_FALSE(bytes_of_pair({triangle, polygon({{0, 0}, {128, 0}, {0, 1}})}));
  EXPECT_FALSE(bytes_of_pair({polygon({{0, 0}, {Rational(1, 2), 0}, {0, 1}}), triangle}));
}

TEST(PairOfBytes, is_rejected_where_what_is_spelled_out_is_not_valid) {
  const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_TRUE(pair_of_bytes(*bytes_of_pair({triangle, triangle})));
  EXPECT_FALSE(
      pair_of_bytes(*bytes_of_pair({polygon({{0, 0}, {4, 0}, {1, 3}, {1, -1}}), triangle})));
  EXPECT_FALSE(bytes_of_pair({Region{}, triangle}));
  EXPECT_FALSE(pair_of_bytes(*bytes_of_pair({polygon({{0, 0}, {1, 0}}), triangle})));
}

}  // namespace
}  // namespace oplus
