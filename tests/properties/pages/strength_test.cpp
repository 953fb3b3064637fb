// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/strength.hpp"

#include <gtest/gtest.h>

#include <set>

namespace oplus {
namespace {

TEST(Strength, is_the_strongest_kind_of_backing) {
  Statement s;
  s.id = "a";
  Registry registry;
  registry.statements = {s};
  const auto expect = [&](Strength expected, const std::string& in_words) {
    EXPECT_EQ(strength(registry, s), expected);
    EXPECT_EQ(backing(registry, s), in_words);
  };
  registry.runs["a"] = {.statement = "a", .run = 40};
  expect(Strength::sampled, "sampled, 40 pairs");
  registry.queries = {{"a.b", "a", "", {}, ""}, {"c.d", "c", "", {}, ""}};
  expect(Strength::solved, "proved by SMT in local form, 1 query; sampled, 40 pairs");
  registry.theorems = {{"a", false, "", "", "", "", "", ""}, {"c", true, "", "", "", "", "", ""}};
  expect(
      Strength::machine_checked_in_part,
      "machine-checked in part, 1 theorem; proved by SMT in local form, 1 query; sampled, 40 pairs");
  registry.runs["a"].enumeration = {7, ""};
  registry.queries.clear();
  expect(Strength::enumerated,
         "proved by enumeration, 7 cases; machine-checked in part, 1 theorem; sampled, 40 pairs");
  registry.theorems = {{"a", true, "", "", "", "", "", ""}, {"a", true, "", "", "", "", "", ""}};
  expect(Strength::machine_checked,
         "machine-checked, 2 theorems; proved by enumeration, 7 cases; sampled, 40 pairs");
}

TEST(Strength, of_a_theorem_in_coq_shows_in_the_border) {
  Statement s;
  s.id = "a";
  Registry registry;
  registry.statements = {s};
  std::set<std::string> colours = {border_colour(registry, s)};
  registry.theorems = {{"a", false, "", "", "", "", "", ""}, {"c", true, "", "", "", "", "", ""}};
  colours.insert(border_colour(registry, s));
  registry.theorems.push_back({"a", true, "", "", "", "", "", ""});
  colours.insert(border_colour(registry, s));
  EXPECT_EQ(colours.size(), 3U);
}

TEST(Strength, has_a_colour_and_a_name_of_its_own) {
  std::set<std::string> colours, names;
  for (const Strength each :
       {Strength::machine_checked, Strength::enumerated, Strength::machine_checked_in_part,
        Strength::solved, Strength::sampled}) {
    colours.insert(colour(each));
    names.insert(to_string(each));
  }
  EXPECT_EQ(colours.size(), 5U);
  EXPECT_EQ(names.size(), 5U);
}

}  // namespace
}  // namespace oplus
