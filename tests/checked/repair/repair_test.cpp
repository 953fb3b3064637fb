// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/repair/repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/families/rich_regions.hpp"
#include "reference/io/unchecked_input.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Region square = polygon(box(0, 0, 4, 4));

TEST(Repair, of_a_region_from_code_names_no_line) {
  const RepairedRegion result =
      repaired(unchecked(polygon({{0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}}), "region"));
  EXPECT_EQ(result.region, square);
  ASSERT_EQ(result.mends.size(), 1U);
  EXPECT_EQ(result.mends[0].kind, MendKind::repeated_vertex);
  EXPECT_EQ(result.mends[0].where.file, "region");
  EXPECT_EQ(result.mends[0].where.line, 0U);
  EXPECT_EQ(
      repaired(unchecked(Region{{{box(0, 0, 4, 4), {{{1, 1}, {2, 2}}, {}}}}}, "region")).region,
      square);
}

Region random_region(Random& random) {
  switch (uniform(random, 0, 2)) {
    case 0:
      return plain_region(random, 8);
    case 1:
      return holed_region(random, 6);
    default:
      return scattered_region(random, 6);
  }
}

std::vector<Chain*> chains_of(Region& region) {
  std::vector<Chain*> all;
  for (Component& component : region.components) {
    all.push_back(&component.outer);
    for (Chain& hole : component.holes) all.push_back(&hole);
  }
  return all;
}

TEST(Repair, leaves_out_spikes_and_the_set_stays) {
  Random random(8);
  for (int i = 0; i < 400; ++i) {
    const Region original = random_region(random);
    Region changed = original;
    for (Chain* chain : chains_of(changed)) {
      for (int more = uniform(random, 0, 3); more > 0; --more) {
        // Forth and back; spikes of spikes come by themselves.
        const std::size_t at = uniform_index(random, chain->size());
        const Point from = (*chain)[at];
        const Rational dx = uniform(random, -3, 3), dy = uniform(random, -3, 3);
        const Point tip = from + Vector{dx, dy};
        const auto behind = chain->begin() + static_cast<std::ptrdiff_t>(at) + 1;
        const Chain spike = one_in(random, 2)
                                ? Chain{tip, from}
                                : Chain{midpoint(from, tip), tip, midpoint(from, tip), from};
        chain->insert(behind, spike.begin(), spike.end());
      }
      std::rotate(
          chain->begin(),
          chain->begin() + static_cast<std::ptrdiff_t>(uniform_index(random, chain->size())),
          chain->end());
      if (one_in(random, 2)) std::reverse(chain->begin(), chain->end());
    }
    const RepairedRegion result = repaired(unchecked(changed, "region"));
    EXPECT_FALSE(find_defect(result.region)) << wkt(changed);
    EXPECT_EQ(canonical_sum(result.region), canonical_sum(original)) << wkt(changed);
    EXPECT_TRUE(repaired(unchecked(result.region, "region")).mends.empty()) << wkt(changed);
  }
}

/// Whatever is read, a fill rule makes a region of it.
TEST(Repair, of_random_chains_by_a_rule_is_valid) {
  Random random(9);
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    Region region;
    for (int components = uniform(random, 1, 3); components > 0; --components) {
      Component& component = region.components.emplace_back();
      component.holes.resize(uniform_index(random, 3));
    }
    for (Chain* chain : chains_of(region)) {
      chain->resize(uniform_index(random, 6) + 1);
      for (Point& p : *chain) {
        p.x = uniform(random, 0, 5);
        p.y = uniform(random, 0, 5);
      }
    }
    for (const FillRule rule : {FillRule::even_odd, FillRule::nonzero})
      EXPECT_FALSE(find_defect(repaired(unchecked(region, "region"), rule).region)) << wkt(region);
    try {
      EXPECT_FALSE(find_defect(repaired(unchecked(region, "region")).region)) << wkt(region);
    } catch (const InvalidInput& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_LT(refused, 490);
}

TEST(Repair, no_chain_becomes_a_hole_that_another_one_is_around) {
  // The one that makes its roles be looked at is the hole that is outside.
  const Region region{{{box(0, 0, 9, 9), {box(20, 20, 21, 21)}}, {box(1, 1, 2, 2), {}}}};
  EXPECT_THROW(repaired(unchecked(region, "region")), InvalidInput);
  EXPECT_THROW(repaired(unchecked(Region{{{{}, {box(0, 0, 1, 1)}}}}, "region")), InvalidInput);
}

TEST(Repair, by_a_rule_has_regard_to_the_directions_of_a_path) {
  const auto filled_area = [](const char* path, FillRule rule) {
    return area(repaired(read_unchecked(path, "in"), rule).region);
  };
  const char* const either_way = "M0 0H4V4H0Z M1 1V5H3V1Z";
  EXPECT_EQ(filled_area(either_way, FillRule::nonzero), 4 * 4 + 2 * 1 - 2 * 3);
  EXPECT_EQ(filled_area("M0 0H4V4H0Z M1 1H3V5H1Z", FillRule::nonzero), 4 * 4 + 2 * 1);
  EXPECT_EQ(filled_area(either_way, FillRule::even_odd), 4 * 4 + 2 * 1 - 2 * 3);
}

}  // namespace
}  // namespace oplus
