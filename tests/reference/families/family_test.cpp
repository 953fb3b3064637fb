// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/family.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "properties/runner/classification.hpp"
#include "reference/definitions/validity.hpp"

namespace oplus {
namespace {

/// FNV-1a over the text of all coordinates, chain by chain.
class Digest {
 public:
  void add(const Region& region) {
    for (const Component& component : region.components) {
      add("component ");
      add(component.outer);
      for (const Chain& hole : component.holes) {
        add("hole ");
        add(hole);
      }
    }
  }
  std::string text() const {
    std::ostringstream out;
    out << std::hex << std::setw(16) << std::setfill('0') << hash_;
    return out.str();
  }

 private:
  void add(const Chain& chain) {
    for (const Point& p : chain) add(p.x.get_str() + "," + p.y.get_str() + " ");
  }
  void add(const std::string& text) {
    for (const char c : text) {
      hash_ ^= static_cast<unsigned char>(c);
      hash_ *= 0x100000001b3u;
    }
  }
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// Counterclockwise outer chains, clockwise holes, at least one component, no defect.
::testing::AssertionResult is_valid(const Region& region) {
  if (region.components.empty()) return ::testing::AssertionFailure() << "no component";
  for (const Component& component : region.components) {
    if (sign(twice_area(component.outer)) <= 0)
      return ::testing::AssertionFailure() << "an outer chain is not counterclockwise";
    for (const Chain& hole : component.holes) {
      if (sign(twice_area(hole)) >= 0)
        return ::testing::AssertionFailure() << "a hole is not clockwise";
    }
  }
  if (const auto defect = find_defect(region))
    return ::testing::AssertionFailure() << describe(defect->kind);
  return ::testing::AssertionSuccess();
}

TEST(Family, has_the_families_of_the_design) {
  std::set<std::string> names;
  for (const Family& family : families()) names.insert(family.name);
  EXPECT_EQ(names, (std::set<std::string>{"grid", "tight", "holes", "components", "convex", "star",
                                          "simple", "comb", "fork", "diamond-u", "islands"}));
  EXPECT_EQ(names.size(), families().size());
}

TEST(Family, is_found_by_its_name) {
  for (const Family& family : families()) EXPECT_EQ(find_family(family.name), &family);
  EXPECT_EQ(find_family("Grid"), nullptr);
  EXPECT_EQ(find_family(""), nullptr);
}

TEST(Family, refuses_too_small_an_n) {
  for (const Family& family : families()) {
    EXPECT_THROW(generate(family, family.smallest - 1, 1), std::invalid_argument) << family.name;
    EXPECT_NO_THROW(generate(family, family.smallest, 1)) << family.name;
  }
}

TEST(Family, makes_valid_regions_of_every_size) {
  for (const Family& family : families()) {
    for (std::size_t n = family.smallest; n <= family.typical + 2; ++n) {
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Summands summands = generate(family, n, seed);
        ASSERT_TRUE(is_valid(summands.p)) << family.name << " n " << n << " seed " << seed;
        ASSERT_TRUE(is_valid(summands.q)) << family.name << " n " << n << " seed " << seed;
      }
    }
  }
}

TEST(Family, makes_larger_regions_than_typical_ones) {
  for (const Family& family : families()) {
    const Summands summands = generate(family, 24, 1);
    EXPECT_TRUE(is_valid(summands.p)) << family.name;
    EXPECT_TRUE(is_valid(summands.q)) << family.name;
  }
}

/// A class of pairs, and how many of a hundred are in it at least and at most.
struct Share {
  std::string classification;
  std::size_t least;
  std::size_t most;
};

// What statements rely on when they name a family; no two families promise the same.
TEST(Family, has_the_shares_of_degenerate_pairs_that_it_is_for) {
  const std::map<std::string, std::vector<Share>> promised = {
      {"comb", {{"reflex vertices", 0, 0}, {"parallel edges", 90, 100}, {"holes", 0, 0}}},
      {"components", {{"several components", 100, 100}, {"parallel edges", 70, 100}}},
      {"convex", {{"reflex vertices", 0, 0}, {"holes", 0, 0}, {"several components", 0, 0}}},
      {"diamond-u", {{"reflex vertices", 0, 0}, {"holes", 0, 0}, {"several components", 0, 0}}},
      {"fork", {{"reflex vertices", 100, 100}, {"parallel edges", 100, 100}}},
      {"grid",
       {{"reflex vertices", 20, 100},
        {"parallel edges", 70, 100},
        {"collinear vertices", 20, 100},
        {"overlapping segments", 10, 100},
        {"holes", 0, 0}}},
      {"holes", {{"holes", 100, 100}, {"parallel edges", 70, 100}}},
      {"islands", {{"several components", 30, 100}, {"parallel edges", 50, 100}}},
      {"simple", {{"reflex vertices", 50, 100}, {"holes", 0, 0}}},
      {"star", {{"reflex vertices", 50, 100}, {"holes", 0, 0}}},
      {"tight", {{"parallel edges", 70, 100}}},
  };
  for (const Family& family : families()) {
    ASSERT_TRUE(promised.count(family.name)) << family.name;
    std::map<std::string, std::size_t> seen;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
      for (const auto& [name, is_so] : named(classify(generate(family, family.typical, seed))))
        seen[name] += is_so ? 1 : 0;
    for (const Share& share : promised.at(family.name)) {
      EXPECT_GE(seen.at(share.classification), share.least)
          << family.name << ' ' << share.classification;
      EXPECT_LE(seen.at(share.classification), share.most)
          << family.name << ' ' << share.classification;
    }
  }
}

TEST(Family, varies_with_the_seed) {
  for (const Family& family : families()) {
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Summands summands = generate(family, family.typical, seed);
      Digest digest;
      digest.add(summands.p);
      digest.add(summands.q);
      seen.insert(digest.text());
    }
    EXPECT_GE(seen.size(), 25u) << family.name;
  }
}

// Each of the first 40 seeds, at the typical n. A change here means that every seed that somebody
// wrote down now means another pair: change it knowingly.
TEST(Family, same_seed_same_polygons_on_every_compiler) {
  std::map<std::string, std::string> digests;
  for (const Family& family : families()) {
    Digest digest;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Summands summands = generate(family, family.typical, seed);
      digest.add(summands.p);
      digest.add(summands.q);
    }
    digests[family.name] = digest.text();
  }
  EXPECT_EQ(digests, (std::map<std::string, std::string>{{"comb", "f1ab9bc67ccb6bb4"},
                                                         {"components", "5b58503fd66cabd4"},
                                                         {"convex", "67bd526d7a3186f4"},
                                                         {"diamond-u", "d1bc13c1a25bdf7f"},
                                                         {"fork", "f43118ec6e4ca0c1"},
                                                         {"grid", "fcb7656619c0b5b3"},
                                                         {"holes", "fd155b03caf92893"},
                                                         {"islands", "25b221315d82bed5"},
                                                         {"simple", "ff4e4d4db550144c"},
                                                         {"star", "f5563cf689f420cd"},
                                                         {"tight", "ff3e5d9fb397aca5"}}));
}

}  // namespace
}  // namespace oplus
