// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/proof_record.hpp"

#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "properties/proofs/smt/query.hpp"
#include "properties/proofs/smt/report.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Returns what `read` makes of the file's JSON; throws InvalidInput where that is not as `read`
/// expects.
template <typename Read>
auto read_json(const fs::path& file, const std::string& expected, Read read) {
  const std::string text = text_of_file(file, expected);
  try {
    return read(Json::parse(text));
  } catch (const nlohmann::json::exception& e) {
    throw InvalidInput({file.string(), 1, 0}, e.what(), expected);
  } catch (const std::invalid_argument&) {
    throw InvalidInput({file.string(), 1, 0}, "not a number", expected);
  }
}

bool extent_is_whole(const std::string& extent, const fs::path& file) {
  if (extent != "whole" && extent != "part")
    throw InvalidInput({file.string(), 1, 0}, "an extent of '" + extent + "'", "whole or part");
  return extent == "whole";
}

/// Numbers and flags by their values, vectors and directions as vectors.
std::string in_words(const Json& counterexample) {
  const smt::Model model = smt::model_of_json(counterexample);
  std::string text;
  const auto add = [&](const std::string& name, const std::string& value) {
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  };
  const auto in_brackets = [](const Vector& v) {
    return "(" + v.x.get_str() + ", " + v.y.get_str() + ")";
  };
  for (const auto& [key, value] : counterexample.items()) {
    const std::string name = key.substr(0, key.find('.'));
    if (key == name)
      add(name, value.is_string() ? value.get<std::string>() : value.dump());
    else if (key == name + ".x")
      add(name, in_brackets(smt::vector_in(model, name)));
    else if (key == name + ".slanted")
      add(name, in_brackets(smt::direction_in(model, name)));
  }
  return text;
}

void expect_answers(const Json& query, const fs::path& file) {
  using smt::Asked;
  std::vector<smt::Question> questions = {{Asked::proof}, {Asked::hypotheses}};
  for (const auto& [name, says] : query.at("hypotheses").items())
    questions.push_back({Asked::twin, name});
  for (const smt::Question& question : questions) {
    const std::string expected = smt::is_expected_satisfiable(question.asked) ? "sat" : "unsat";
    for (const auto& [solver, answer] : query.at("answers").at(to_string(question)).items())
      if (answer != expected)
        throw InvalidInput({file.string(), 1, 0},
                           query.at("id").get<std::string>() + ": " + solver + " answers " +
                               answer.dump() + " to " + to_string(question),
                           expected);
  }
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
                          .conclusion = entry.at("conclusion")};
      for (const auto& [name, says] : entry.at("hypotheses").items())
        query.hypotheses.push_back({says, in_words(entry.at("counterexamples").at(name))});
      queries.push_back(std::move(query));
    }
    return queries;
  });
}

}  // namespace oplus
