// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace oplus {
namespace {

TEST(Registry, ListsStatementsInTheOrderOfTheirNumbers) {
  std::vector<std::string> ids;
  for (const Statement& s : statements()) ids.push_back(s.id);
  const std::vector<std::string> first = {"theorem-2.2.10", "theorem-2.3.2", "lemma-4.1.4",
                                          "theorem-4.2.1", "fact-convolution-size"};
  auto from = ids.begin();
  for (const std::string& id : first) {
    from = std::find(from, ids.end(), id);
    EXPECT_NE(from, ids.end()) << id;
  }
}

TEST(Registry, AddsTheTexts) {
  const std::vector<Statement> all = statements();
  for (const Statement& s : all) EXPECT_EQ(s.text.id, s.id);
  const auto& text = std::ranges::find(all, "lemma-4.1.4", &Statement::id)->text;
  EXPECT_EQ(text.title, "In-degree equals out-degree in the convolution graph");
  EXPECT_TRUE(text.statement.starts_with("At each node of ") && text.statement.ends_with("."));
  EXPECT_TRUE(text.why.starts_with("At a state, "));
  EXPECT_EQ(text.hypotheses.size(), 2U);
  EXPECT_EQ(text.rests_on, std::vector<std::string>{"lemma-4.1.3"});
  EXPECT_TRUE(text.backing.starts_with("machine-checked as printed, "));
}

TEST(Registry, KnowsTheFileOfAStatement) {
  EXPECT_EQ(relative_file(Statement{}), "tests/properties/runner/registry_test.cpp");
}

}  // namespace
}  // namespace oplus
