// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace oplus {

/// A theorem of properties/proofs/ that backs a statement: an entry of theorems.json.
struct ProvedTheorem {
  std::string statement;  ///< the id of the registered statement
  bool is_whole =
      false;  ///< whether it is the whole statement, not only a part or an ingredient of it
  std::string name, file;
  std::string gloss;        ///< what it says, for readers without Coq
  std::string covers;       ///< which inputs exactly
  std::string not_covered;  ///< which part of the statement remains unproved
  std::string formal;       ///< its statement in Coq
};

/// Reads theorems.json of this folder, and the formal statements from the files it names.
/// Throws InvalidInput on what cannot be read, and where a file has no theorem of that name.
std::vector<ProvedTheorem> proved_theorems(const std::filesystem::path& proofs);

/// From the line "Theorem NAME" (or Lemma, Corollary) up to the line before "Proof"; empty if there
/// is no such theorem.
std::string formal_statement(const std::string& coq, const std::string& name);

/// What oplus-check smt --record wrote of a query, of which each solver gave the expected answers.
struct AnsweredQuery {
  struct Hypothesis {
    std::string says;
    std::string counterexample;  ///< to the statement without it, in words
  };

  std::string id;
  std::string statement;
  std::string file;  ///< from the root
  std::vector<Hypothesis> hypotheses;
  std::string conclusion;
};

/// Reads results.json of this folder. Throws InvalidInput on what cannot be read, and where an answer is
/// not the expected one.
std::vector<AnsweredQuery> answered_queries(const std::filesystem::path& smt);

}  // namespace oplus
