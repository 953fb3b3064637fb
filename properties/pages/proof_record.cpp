// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/proof_record.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "reference/io/file_text.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What `read` makes of the file's JSON; where that is not as it expects, InvalidInput.
template <typename Read>
auto read_json(const fs::path& file, const std::string& expected, Read read) {
  const std::string text = text_of_file(file, expected);
  try {
    return read(Json::parse(text));
  } catch (const nlohmann::json::exception& e) {
    throw InvalidInput({file.string(), 1, 0}, e.what(), expected);
  }
}

bool extent_is_whole(const std::string& extent, const fs::path& file) {
  if (extent != "whole" && extent != "part")
    throw InvalidInput({file.string(), 1, 0}, "an extent of '" + extent + "'", "whole or part");
  return extent == "whole";
}

/// Numbers as they are; what a model says of a direction (properties/smt/values.hpp) as its vector.
std::string in_words(const Json& counterexample) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& value) {
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  };
  for (const auto& [key, value] : counterexample.items()) {
    const std::string name = key.substr(0, key.find('.'));
    const std::string part = key.substr(std::min(name.size() + 1, key.size()));
    if (part.empty())
      add(name, value.is_string() ? value.get<std::string>() : value.dump());
    else if (part == "x")
      add(name, "(" + value.get<std::string>() + ", " +
                    counterexample.at(name + ".y").get<std::string>() + ")");
    else if (part == "slanted") {
      const std::string one = counterexample.at(name + ".positive") ? "1" : "-1";
      add(name, value ? "(" + counterexample.at(name + ".t").get<std::string>() + ", " + one + ")"
                      : "(" + one + ", 0)");
    }
  }
  return text;
}

/// The proof is expected to be unsatisfiable, the rest satisfiable, with every solver.
void expect_answers(const Json& query, const fs::path& file) {
  const Json& answers = query.at("answers");
  for (const char* asked : {"proof", "hypotheses", "twin"})
    for (const auto& [solver, answer] : answers.at(asked).items())
      if (const std::string expected = asked == std::string("proof") ? "unsat" : "sat";
          answer != expected)
        throw InvalidInput({file.string(), 1, 0},
                           query.at("id").get<std::string>() + ": " + solver + " answers " +
                               answer.dump() + " to " + asked,
                           expected);
}

}  // namespace

std::string formal_statement(const std::string& coq, const std::string& name) {
  const std::regex start("(^|\n)(Theorem|Lemma|Corollary) " + name + "\\b");
  std::smatch found;
  if (!std::regex_search(coq, found, start)) return {};
  const std::size_t from = static_cast<std::size_t>(found.position(2));
  const std::size_t to = coq.find("\nProof", from);
  return to == std::string::npos ? std::string() : coq.substr(from, to - from);
}

std::vector<ProvedTheorem> proved_theorems(const fs::path& proofs) {
  const fs::path file = proofs / "theorems.json";
  std::vector<ProvedTheorem> theorems = read_json(
      file, "a list of theorems: statement, extent, theorem, file, gloss, covers, not_covered",
      [&](const Json& list) {
        std::vector<ProvedTheorem> all;
        for (const Json& entry : list)
          all.push_back({.statement = entry.at("statement"),
                         .is_whole = extent_is_whole(entry.at("extent"), file),
                         .name = entry.at("theorem"),
                         .file = entry.at("file"),
                         .gloss = entry.at("gloss"),
                         .covers = entry.at("covers"),
                         .not_covered = entry.at("not_covered"),
                         .formal = {}});
        return all;
      });
  for (ProvedTheorem& theorem : theorems) {
    theorem.formal =
        formal_statement(text_of_file(proofs / theorem.file, "a file of proofs"), theorem.name);
    if (theorem.formal.empty())
      throw InvalidInput({(proofs / theorem.file).string(), 1, 0}, "no theorem " + theorem.name,
                         "what theorems.json names");
  }
  return theorems;
}

std::vector<AnsweredQuery> answered_queries(const fs::path& smt) {
  const fs::path file = smt / "results.json";
  return read_json(file, "what oplus-check smt --record writes", [&](const Json& record) {
    std::vector<AnsweredQuery> queries;
    for (const Json& entry : record.at("queries")) {
      expect_answers(entry, file);
      AnsweredQuery query{.id = entry.at("id"),
                          .statement = entry.at("statement"),
                          .file = entry.at("file"),
                          .hypotheses = {},
                          .conclusion = entry.at("conclusion"),
                          .dropped = entry.at("hypotheses").at(entry.at("dropped")),
                          .counterexample = in_words(entry.at("counterexample"))};
      for (const auto& [name, says] : entry.at("hypotheses").items())
        query.hypotheses.push_back(says);
      queries.push_back(std::move(query));
    }
    return queries;
  });
}

}  // namespace oplus
