// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "checked/operations/image.hpp"
#include "properties/runner/source_tree.hpp"
#include "properties/statements/chapter5/boundary_contact.hpp"
#include "reference/definitions/collision.hpp"
#include "tests/checked/collision/each_method.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

/// b moved by x, in words its strongest contact with a, and whether the interiors meet.
struct Placement {
  std::string name;
  Point x;
  std::string contact;
  bool meet;
};

/// Two regions and places for the second, asked one after the other of one collision test.
struct Pair {
  std::string name;
  Region a;
  Region b;
  std::vector<Placement> placements;
};

std::vector<Pair> pairs() {
  std::ifstream file(source_root() / "tests/corpus/named_placements.json");
  std::vector<Pair> result;
  for (const nlohmann::json& pair : nlohmann::json::parse(file)) {
    const auto region = [&](const char* which) { return region_from(pair.at(which)).region; };
    result.push_back({pair.at("name"), region("a"), region("b"), {}});
    for (const nlohmann::json& of_pair : pair.at("placements")) {
      const auto coordinate = [&](std::size_t i) {
        return Rational(of_pair.at("x").at(i).get<std::string>());
      };
      result.back().placements.push_back({of_pair.at("name"),
                                          {coordinate(0), coordinate(1)},
                                          of_pair.at("contact"),
                                          of_pair.at("meet")});
    }
  }
  EXPECT_EQ(result.size(), 28U);
  return result;
}

std::string where(const Pair& pair, const Placement& placement) {
  return pair.name + ": " + placement.name;
}

TEST(NamedPlacements, are_what_their_names_say) {
  for (const Pair& pair : pairs()) {
    for (const Placement& placement : pair.placements) {
      const Region b = translated(pair.b, placement.x);
      EXPECT_EQ(describe(strongest_contact(pair.a, b)), placement.contact)
          << where(pair, placement);
      EXPECT_EQ(interiors_meet(pair.a, b), placement.meet) << where(pair, placement);
    }
  }
}

TEST(NamedPlacements, are_decided_by_every_method_either_way_round) {
  for (const Pair& pair : pairs()) {
    const EachMethod each(pair.a, reflected(pair.b));
    const EachMethod exchanged(pair.b, reflected(pair.a));
    for (const Placement& placement : pair.placements) {
      EXPECT_EQ(each.wrong_at(placement.x, placement.meet), "") << where(pair, placement);
      EXPECT_EQ(exchanged.wrong_at(-placement.x, placement.meet), "")
          << where(pair, placement) << ", exchanged";
    }
  }
}

/// Shears and scales, so that nothing is horizontal, vertical or an integer.
const AffineMap slanted{Rational(1, 3), Rational(1, 7), Rational(-1, 13), Rational(1, 11)};

TEST(NamedPlacements, are_decided_by_every_method_where_no_coordinate_is_a_double) {
  for (const Pair& pair : pairs()) {
    const EachMethod each(image(slanted, pair.a), reflected(image(slanted, pair.b)));
    for (const Placement& placement : pair.placements)
      EXPECT_EQ(each.wrong_at(slanted(placement.x), placement.meet), "") << where(pair, placement);
  }
}

}  // namespace
}  // namespace oplus
