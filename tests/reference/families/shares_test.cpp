// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "properties/runner/classification.hpp"
#include "reference/families/family.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {
namespace {

using Features = std::map<std::string, bool>;

Features of_summands(const Summands& pair) {
  return {{"P has a hole", has_hole(pair.p)},
          {"Q has a hole", has_hole(pair.q)},
          {"P has several components", pair.p.components.size() > 1},
          {"Q has several components", pair.q.components.size() > 1},
          {"P equals Q", pair.p == pair.q},
          {"P equals -Q", pair.p == reflected(pair.q)}};
}

/// Of the tight passages: they are small enough for the oracle.
Features of_both_sums(const Summands& pair) {
  const OracleSums sums = oracle_sums(pair.p, pair.q);
  const bool dangling = !sums.open.dangling_edges.empty();
  const bool isolated = !sums.open.isolated_vertices.empty();
  return {{"dangling edges", dangling},
          {"isolated vertices", isolated},
          {"low-dimensional features", dangling || isolated},
          {"holes of the closed sum", !sums.closed.holes.empty()}};
}

Features of_moats(const Summands& pair) {
  const PlanarSet open = sum_by_winding_numbers(pair.p, pair.q, Boundary::open).sum;
  return {{"islands", open.outer.size() > 1},
          {"exact fits", !open.dangling_edges.empty() || !open.isolated_vertices.empty()},
          {"filled moats", open.outer.size() < pair.p.components.size()}};
}

Features of_perturbation(const Summands& pair) {
  const Rational eps1 = 3 - pair.p.components[0].outer[10].x;
  const bool none = eps1 == 0;
  const bool small = eps1 > 0 && eps1 < Rational(1, 1'000'000);
  const bool larger = eps1 > Rational(1, 10'000) && eps1 < 3;
  return {{"no perturbation", none},
          {"small perturbation", small},
          {"larger perturbation", larger},
          {"one of these perturbations", none || small || larger}};
}

/// How many of a hundred pairs of a family have a feature.
struct Share {
  std::string family;
  std::string feature;
  int least;
  int most;
};

// What statements rely on when they name a family; no two families promise the same.
const std::vector<Share> promised{
    {"coast", "reflex vertices", 20, 100},
    {"coast", "holes", 0, 0},
    {"comb", "reflex vertices", 0, 0},
    {"comb", "parallel edges", 90, 100},
    {"comb", "holes", 0, 0},
    {"components", "several components", 100, 100},
    {"components", "parallel edges", 70, 100},
    {"components", "P has several components", 100, 100},
    {"components", "Q has several components", 13, 100},
    {"dots", "P has several components", 100, 100},
    {"dots", "Q has several components", 100, 100},
    {"fractions", "holes", 0, 0},
    {"fractions", "parallel edges", 0, 5},
    {"maze", "parallel edges", 50, 100},
    {"maze", "holes", 0, 0},
    {"outlier", "holes", 0, 0},
    {"outlier", "parallel edges", 80, 100},
    {"pockets", "P has a hole", 100, 100},
    {"pockets", "low-dimensional features", 50, 100},
    {"scales", "reflex vertices", 30, 100},
    {"sieve", "P has a hole", 100, 100},
    {"sieve", "Q has a hole", 0, 0},
    {"spiral", "parallel edges", 90, 100},
    {"spiral", "holes", 0, 0},
    {"thin", "several components", 0, 0},
    {"thin", "holes", 0, 0},
    {"touching", "P has several components", 100, 100},
    {"touching", "parallel edges", 100, 100},
    {"convex", "reflex vertices", 0, 0},
    {"convex", "holes", 0, 0},
    {"convex", "several components", 0, 0},
    {"diamond-u", "reflex vertices", 0, 0},
    {"diamond-u", "holes", 0, 0},
    {"diamond-u", "several components", 0, 0},
    {"diamond-u", "no perturbation", 20, 60},
    {"diamond-u", "small perturbation", 20, 60},
    {"diamond-u", "larger perturbation", 20, 60},
    {"diamond-u", "one of these perturbations", 100, 100},
    {"fork", "reflex vertices", 100, 100},
    {"fork", "parallel edges", 100, 100},
    {"grid", "reflex vertices", 35, 100},
    {"grid", "parallel edges", 85, 100},
    {"grid", "collinear vertices", 50, 100},
    {"grid", "overlapping segments", 10, 100},
    {"grid", "holes", 0, 0},
    {"grid", "several components", 0, 0},
    {"grid", "P equals Q", 1, 10},
    {"grid", "P equals -Q", 1, 10},
    {"holes", "holes", 100, 100},
    {"holes", "parallel edges", 70, 100},
    {"holes", "P has a hole", 100, 100},
    {"holes", "Q has a hole", 30, 70},
    {"islands", "several components", 30, 100},
    {"islands", "parallel edges", 50, 100},
    {"islands", "islands", 17, 100},
    {"islands", "exact fits", 34, 100},
    {"islands", "filled moats", 17, 100},
    {"simple", "reflex vertices", 50, 100},
    {"simple", "holes", 0, 0},
    {"star", "reflex vertices", 50, 100},
    {"star", "holes", 0, 0},
    {"tight", "parallel edges", 70, 100},
    {"tight", "dangling edges", 20, 100},
    {"tight", "isolated vertices", 20, 100},
    {"tight", "low-dimensional features", 50, 99},  // some do not fit, or have room
    {"tight", "holes of the closed sum", 1, 100},
};

TEST(Family, has_the_shares_of_pairs_that_it_is_for) {
  using FeaturesOf = Features (*)(const Summands&);
  const std::map<std::string, FeaturesOf> more{{"diamond-u", of_perturbation},
                                               {"islands", of_moats},
                                               {"pockets", of_both_sums},
                                               {"tight", of_both_sums}};
  for (const Family& family : families()) {
    std::map<std::string, int> seen;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const Summands pair = generate(family, family.typical, seed);
      Features features = named(classify(pair));
      features.merge(of_summands(pair));
      if (more.contains(family.name)) features.merge(more.at(family.name)(pair));
      for (const auto& [feature, is_so] : features) seen[feature] += is_so ? 1 : 0;
    }
    int promises = 0;
    for (const Share& share : promised) {
      if (share.family != family.name) continue;
      ++promises;
      EXPECT_GE(seen.at(share.feature), share.least) << family.name << ' ' << share.feature;
      EXPECT_LE(seen.at(share.feature), share.most) << family.name << ' ' << share.feature;
    }
    EXPECT_GT(promises, 0) << family.name;
  }
}

}  // namespace
}  // namespace oplus
