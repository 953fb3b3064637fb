// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/statement_graph.hpp"

#include <gtest/gtest.h>

#include "properties/runner/registry.hpp"

namespace oplus {
namespace {

using Defects = std::vector<std::string>;

Statement resting_on(const std::string& id, const std::vector<std::string>& below) {
  Statement s;
  s.id = id;
  s.title = "Title of " + id;
  s.rests_on = below;
  return s;
}

TEST(StatementGraph, OfTheRegistryHasNoDefect) {
  EXPECT_EQ(defects_of_graph(statements()), Defects{});
}

TEST(StatementGraph, MayReachAStatementOnTwoPaths) {
  EXPECT_EQ(defects_of_graph({resting_on("a", {}), resting_on("b", {"a"}), resting_on("c", {"a"}),
                              resting_on("d", {"b", "c"})}),
            Defects{});
}

TEST(StatementGraph, NamesACycle) {
  EXPECT_EQ(defects_of_graph({resting_on("a", {"c"}), resting_on("b", {"a"}),
                              resting_on("c", {"b"}), resting_on("d", {"a"})}),
            Defects{"a, b, c: rest on each other"});
}

TEST(StatementGraph, NamesStatementsThatRestOnThemselvesOrOnUnknownOnes) {
  EXPECT_EQ(defects_of_graph({resting_on("a", {"a"}), resting_on("b", {"z"})}),
            (Defects{"a: rests on itself", "b: rests on an unknown z"}));
}

TEST(StatementGraph, IsWrittenForGraphviz) {
  const std::string dot =
      to_dot({resting_on("a", {}), resting_on("b", {"a"})}, [](const Statement& s) {
        return s.id == "a" ? NodeColours{"#123456", "#654321"} : NodeColours{"#abcdef", "#fedcba"};
      });
  EXPECT_NE(
      dot.find(
          "0[label=\"a\", URL=\"a.md\", tooltip=\"Title of a\", fillcolor=\"#123456\", color=\"#654321\"]"),
      std::string::npos)
      << dot;
  EXPECT_NE(dot.find("1->0"), std::string::npos) << dot;
  EXPECT_EQ(dot.find("0->1"), std::string::npos) << dot;
}

}  // namespace
}  // namespace oplus
