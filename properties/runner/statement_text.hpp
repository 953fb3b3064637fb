// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace oplus {

/// What is said of a statement, in properties/statements/*/statements.md.
struct StatementText {
  std::string id;
  std::string title;      ///< a line
  std::string statement;  ///< in our own words
  std::string why;        ///< why it holds, in a few lines
  std::vector<std::string> hypotheses;
  std::vector<std::string> rests_on;  ///< ids of statements
  std::string backing;                ///< what backs it when this was built, as its page says
};

/// All of them; properties/pages/embed_texts.py collects them when this is built.
const std::vector<StatementText>& statement_texts();

}  // namespace oplus
