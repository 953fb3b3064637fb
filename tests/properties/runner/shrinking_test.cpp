// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/shrinking.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "reference/chains/validity.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus {
namespace {

bool has_reflex_vertex(const Region& region) {
  for (const Chain& chain : chains(region)) {
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (is_reflex(corner_at(chain, i))) return true;
  }
  return false;
}

std::size_t hole_count(const Region& region) {
  return chains(region).size() - region.components.size();
}

bool on_integers_up_to(const Rational& bound, const Summands& summands) {
  for (const Region* region : {&summands.p, &summands.q})
    for (const Chain& chain : chains(*region))
      for (const Point& p : chain)
        for (const Rational& v : {p.x, p.y})
          if (v.get_den() != 1 || abs(v) > bound) return false;
  return true;
}

void expect_valid(const Region& region) {
  ASSERT_FALSE(region.components.empty());
  for (const Component& component : region.components) {
    EXPECT_GT(twice_area(component.outer), 0);
    for (const Chain& hole : component.holes) EXPECT_LT(twice_area(hole), 0);
  }
  EXPECT_EQ(find_defect(region), std::nullopt);
}

TEST(Smaller, every_candidate_is_valid_and_smaller_in_every_family) {
  for (const Family& family : families()) {
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      const Summands summands = generate(family, family.smallest + seed, seed);
      const std::vector<Summands> candidates = smaller(summands);
      EXPECT_GE(candidates.size(), 10u) << family.name;
      for (const Summands& candidate : candidates) {
        EXPECT_LT(size_of(candidate), size_of(summands)) << family.name;
        expect_valid(candidate.p);
        expect_valid(candidate.q);
      }
    }
  }
}

// Whatever fails, a way down is one of these: each step valid and smaller, and there is an end.
TEST(Smaller, every_sequence_stays_valid_and_ends_in_two_triangles) {
  for (const Family& family : families()) {
    Random random(7);
    Summands at = generate(family, family.smallest, 7);
    for (std::vector<Summands> below = smaller(at); !below.empty(); below = smaller(at)) {
      Summands step = std::move(below[uniform_index(random, below.size())]);
      ASSERT_LT(size_of(step), size_of(at)) << family.name;
      expect_valid(step.p);
      expect_valid(step.q);
      at = std::move(step);
    }
    EXPECT_EQ(size_of(at).vertices, 6u) << family.name;
  }
}

TEST(Smaller, leaves_out_each_part) {
  const Region two{
      {{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{1, 1}, {1, 2}, {2, 1}}, {{2, 5}, {2, 6}, {3, 5}}}},
       {{{20, 0}, {21, 0}, {20, 1}}, {}}}};
  const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  const std::vector<Summands> candidates = smaller({two, triangle});
  const auto some = [&](auto is_wanted) {
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](const Summands& s) { return is_wanted(s.p); });
  };
  EXPECT_TRUE(
      some([&](const Region& r) { return r.components == std::vector{two.components[0]}; }));
  EXPECT_TRUE(
      some([&](const Region& r) { return r.components == std::vector{two.components[1]}; }));
  EXPECT_TRUE(some([](const Region& r) { return r.components.size() == 2 && hole_count(r) == 1; }));
  EXPECT_TRUE(some([](const Region& r) { return r.components.size() == 2 && hole_count(r) == 0; }));
  EXPECT_TRUE(some([](const Region& r) {
    return r.components.size() == 2 && hole_count(r) == 2 && r.components[0].outer.size() == 3;
  }));
  for (const Summands& candidate : candidates) EXPECT_NE(size_of(candidate).vertices, 0u);
}

TEST(Shrink, a_reflex_vertex_ends_in_four_vertices_and_a_triangle) {
  const auto fails = [](const Summands& s) { return has_reflex_vertex(s.p); };
  for (const char* name : {"grid", "star", "holes", "components", "tight", "fork"}) {
    const Family& family = *find_family(name);
    int tried = 0;
    for (std::uint64_t seed = 0; tried < 3; ++seed) {
      const Summands summands = generate(family, family.typical, seed);
      if (!fails(summands)) continue;
      ++tried;
      const Summands least = shrink(summands, fails);
      EXPECT_TRUE(fails(least));
      expect_valid(least.p);
      expect_valid(least.q);
      EXPECT_EQ(vertex_count(least.p), 4u) << name << " seed " << seed;
      EXPECT_EQ(vertex_count(least.q), 3u) << name << " seed " << seed;
      EXPECT_TRUE(on_integers_up_to(3, least)) << name << " seed " << seed;
    }
  }
}

TEST(Shrink, a_hole_ends_in_a_triangle_in_a_triangle) {
  const auto fails = [](const Summands& s) { return hole_count(s.p) > 0; };
  const Family& family = *find_family("holes");
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Summands least = shrink(generate(family, family.typical, seed), fails);
    EXPECT_EQ(least.p.components.size(), 1u);
    EXPECT_EQ(hole_count(least.p), 1u);
    EXPECT_EQ(vertex_count(least.p), 6u) << seed;
    EXPECT_EQ(vertex_count(least.q), 3u) << seed;
    EXPECT_TRUE(on_integers_up_to(6, least)) << seed;
  }
}

TEST(Shrink, anything_ends_in_two_unit_triangles) {
  const auto fails = [](const Summands&) { return true; };
  for (const Family& family : families()) {
    const Summands least = shrink(generate(family, family.typical, 1), fails);
    EXPECT_EQ(size_of(least).vertices, 6u) << family.name;
    EXPECT_TRUE(on_integers_up_to(1, least)) << family.name;
  }
}

TEST(Shrink, refuses_a_pair_that_does_not_fail) {
  const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_THROW(shrink({triangle, triangle}, [](const Summands&) { return false; }),
               ContractViolation);
}

}  // namespace
}  // namespace oplus
