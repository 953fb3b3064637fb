// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/repair/repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/families/rich_regions.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

RepairedRegion repaired_text(const std::string& text, std::optional<FillRule> fill = {}) {
  return repaired(read_unchecked(text, "file"), fill);
}

/// "line:column: what", a line each.
std::string done(const RepairedRegion& result) {
  std::string all;
  for (const Mend& mend : result.mends)
    all += std::to_string(mend.where.line) + ":" + std::to_string(mend.where.column) + ": " +
           mend.what + "\n";
  return all;
}

const Region square = polygon(box(0, 0, 4, 4));

struct Row {
  std::string name;
  std::string text;
  std::string region;  ///< in WKT
  std::string done;

  friend void PrintTo(const Row& row, std::ostream* out) { *out << row.text; }
};

class RepairOf : public testing::TestWithParam<Row> {};

TEST_P(RepairOf, gives_a_region_and_says_what_was_done) {
  const RepairedRegion result = repaired_text(GetParam().text);
  EXPECT_EQ(wkt(result.region), GetParam().region);
  EXPECT_EQ(done(result), GetParam().done);
  EXPECT_FALSE(find_defect(result.region));
}

INSTANTIATE_TEST_SUITE_P(
    All, RepairOf,
    testing::ValuesIn(std::vector<Row>{
        {"nothing", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
         ""},
        {"empty", "POLYGON EMPTY", "POLYGON EMPTY", ""},
        {"vertices_in_line_stay", "POLYGON ((0 0, 2 0, 4 0, 4 4, 0 4, 0 0))",
         "POLYGON ((0 0, 2 0, 4 0, 4 4, 0 4, 0 0))", ""},
        {"repeated_vertices", "POLYGON ((0 0, 4 0, 4 0,\n 4 0, 4 4, 0 4, 0 0, 0 0))",
         "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
         "1:21: vertex 3 of outer chain of component 1 is equal to vertex 2, (4, 0); left out\n"
         "2:2: vertex 4 of outer chain of component 1 is equal to vertex 2, (4, 0); left out\n"
         "2:17: vertex 7 of outer chain of component 1 is equal to vertex 1, (0, 0); left out\n"},
        {"spike", "6 0 0 4 0 8 0 4 0 4 4 0 4", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
         "1:11: vertex 3 of outer chain of component 1, (8, 0), is the tip of a spike; left out\n"
         "1:15: vertex 4 of outer chain of component 1 is equal to vertex 2, (4, 0); left out\n"},
        {"spike_in_several_steps", "POLYGON ((0 0, 4 0, 6 0, 7 1, 6 0, 9 0, 4 0, 4 4, 0 4, 0 0))",
         "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
         "1:21: vertex 3 of outer chain of component 1, (6, 0), is the tip of a spike; left out\n"
         "1:26: vertex 4 of outer chain of component 1, (7, 1), is the tip of a spike; left out\n"
         "1:31: vertex 5 of outer chain of component 1 is equal to vertex 3, (6, 0); left out\n"
         "1:36: vertex 6 of outer chain of component 1, (9, 0), is the tip of a spike; left out\n"
         "1:41: vertex 7 of outer chain of component 1 is equal to vertex 2, (4, 0); left out\n"},
        {"spike_at_the_start", "POLYGON ((9 9, 4 4, 0 4, 0 0, 4 0, 4 4, 9 9))",
         "POLYGON ((4 4, 0 4, 0 0, 4 0, 4 4))",
         "1:11: vertex 1 of outer chain of component 1, (9, 9), is the tip of a spike; left out\n"
         "1:36: vertex 6 of outer chain of component 1 is equal to vertex 2, (4, 4); left out\n"},
        {"open_ring", "POLYGON ((0 0, 4 0, 4 4,\n0 4), (1 1, 1 2, 2 2))",
         "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1))",
         "2:1: outer chain of component 1 was not closed; an edge goes from (0, 4) to (0, 0)\n"
         "2:18: hole 1 of component 1 was not closed; an edge goes from (2, 2) to (1, 1)\n"},
        {"open_svg_path", "M 0 0 H 4 V 4 H 0", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
         "1:17: outer chain of component 1 was not closed; an edge goes from (0, 4) to (0, 0)\n"},
        {"orientation", "MULTIPOLYGON (((0 0, 0 4, 4 4, 4 0, 0 0),(1 1, 2 2, 1 2, 1 1)))",
         "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1))",
         "1:16: outer chain of component 1 was clockwise; turned\n"
         "1:42: hole 1 of component 1 was counterclockwise; turned\n"},
        {"hole_without_area", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 2, 3 3, 2 2, 1 1))",
         "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
         "1:37: hole 1 of component 1 encloses nothing; left out\n"},
        {"outer_chain_without_area",
         "MULTIPOLYGON (((0 0, 9 9, 0 0), (1 1, 1 2, 2 1, 1 1)), ((0 0, 4 0, 4 4, 0 4, 0 0)))",
         "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
         "1:16: outer chain of component 1 encloses nothing; left out\n"
         "1:33: hole 1 of component 1 has no outer chain any more; left out\n"},
        {"point", "POLYGON ((1 1, 1 1))", "POLYGON EMPTY",
         "1:10: outer chain of component 1 encloses nothing; left out\n"},
        {"hole_first", "POLYGON ((1 1, 1 2, 2 2, 1 1), (0 0, 4 0, 4 4, 0 4, 0 0))",
         "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1))",
         "1:10: outer chain of component 1 is now hole 1 of component 1\n"
         "1:32: hole 1 of component 1 is now outer chain of component 1\n"},
        {"hole_beside", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (5 0, 6 0, 5 1, 5 0))",
         "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((5 0, 6 0, 5 1, 5 0)))",
         "1:37: hole 1 of component 1 is now outer chain of component 2\n"},
        {"hole_of_another_component",
         "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)),"
         " ((5 0, 6 0, 5 1, 5 0), (1 1, 1 2, 2 2, 1 1)))",
         "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1)), ((5 0, 6 0, 5 1, 5 0)))",
         "1:67: hole 1 of component 2 is now hole 1 of component 1\n"},
        {"island_as_a_hole",
         "POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 1 5, 5 1, 1 1), (2 2, 3 2, 2 3, 2 2))",
         "MULTIPOLYGON (((0 0, 9 0, 0 9, 0 0), (1 1, 1 5, 5 1, 1 1)), ((2 2, 3 2, 2 3, 2 2)))",
         "1:54: hole 2 of component 1 is now outer chain of component 2\n"}}),
    [](const auto& test) { return test.param.name; });

TEST(Repair, refuses_what_needs_a_fill_rule_and_says_where_it_is_in_the_input) {
  EXPECT_EQ(
      refusal([] { repaired_text("POLYGON ((0 0, 0 0, 2 2,\n 2 0, 0 2, 0 0))"); }),
      "file:2:2: two edges of outer chain of component 1 cross at (1, 1): edge 1 from (0, 0) to "
      "(2, 2) and edge 4 from (2, 0) to (0, 2); expected what can be repaired without a fill "
      "rule");
  // A polygon inside another one may be a hole, or add nothing.
  EXPECT_EQ(
      refusal([] { repaired_text("[[[[0,0],[9,0],[0,9]]], [[[1,1],[2,1],[1,2]]]]"); }),
      "file:1:27: outer chain of component 2 at (1, 1) is inside outer chain of component 1 and "
      "in none of its holes; expected what can be repaired without a fill rule");
  EXPECT_EQ(refusal([] { repaired_text("POLYGON ((0 0, 1 0"); }).substr(0, 9), "file:1:19");
}

TEST(Repair, fills_by_a_rule_only_where_it_must) {
  const std::string crossing = "[[0, 0], [0, 0], [2, 2], [2, 0],\n [0, 2]]";
  for (const FillRule rule : {FillRule::even_odd, FillRule::nonzero}) {
    const RepairedRegion result = repaired_text(crossing, rule);
    EXPECT_EQ(wkt(result.region), "MULTIPOLYGON (((1 1, 2 0, 2 2, 1 1)), ((0 0, 1 1, 0 2, 0 0)))");
    ASSERT_EQ(result.mends.size(), 2U);
    EXPECT_EQ(result.mends[1].kind, MendKind::filled);
    EXPECT_TRUE(result.mends[1].what.ends_with(
        rule == FillRule::even_odd
            ? "cross at (1, 1): edge 1 from (0, 0) to (2, 2) and edge 4 from "
              "(2, 0) to (0, 2); all chains filled by the rule even-odd"
            : "all chains filled by the rule nonzero"))
        << result.mends[1].what;
    EXPECT_TRUE(repaired_text("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", rule).mends.empty());
  }
  const std::string nested = "[[[[0,0],[9,0],[0,9]]], [[[1,1],[2,1],[1,2]]]]";
  EXPECT_EQ(wkt(repaired_text(nested, FillRule::even_odd).region),
            "POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 1 2, 2 1, 1 1))");
  EXPECT_EQ(wkt(repaired_text(nested, FillRule::nonzero).region), "POLYGON ((0 0, 9 0, 0 9, 0 0))");
}

TEST(Repair, fills_an_svg_path_as_its_chains_run_and_other_chains_as_they_are_named) {
  const std::string against = "M0 0H4V4H0Z M2 2V6H6V2Z";
  EXPECT_EQ(area(repaired_text(against, FillRule::nonzero).region), 24);
  EXPECT_EQ(area(repaired_text(against, FillRule::even_odd).region), 24);
  const std::string along = "M0 0H4V4H0Z M2 2H6V6H2Z";
  EXPECT_EQ(area(repaired_text(along, FillRule::nonzero).region), 28);
  EXPECT_EQ(area(repaired_text(along, FillRule::even_odd).region), 24);
  const std::string polygons =
      "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON ((2 2, 2 6, 6 6, 6 2, 2 2))";
  EXPECT_EQ(area(repaired_text(polygons, FillRule::nonzero).region), 28);
}

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

TEST(Repair, leaves_out_the_repeated_vertices_that_were_put_in_and_nothing_else) {
  Random random(7);
  for (int i = 0; i < 400; ++i) {
    const Region original = random_region(random);
    Region changed = original;
    std::size_t count = 0;
    for (Chain* chain : chains_of(changed)) {
      for (int more = uniform(random, 0, 3); more > 0; --more, ++count) {
        const std::size_t at = uniform_index(random, chain->size());
        const Point copy = (*chain)[at];
        chain->insert(chain->begin() + static_cast<std::ptrdiff_t>(at), copy);
      }
    }
    const RepairedRegion result = repaired(unchecked(changed, "region"));
    EXPECT_EQ(result.region, original) << wkt(changed);
    EXPECT_EQ(result.mends.size(), count) << wkt(changed);
  }
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

}  // namespace
}  // namespace oplus
