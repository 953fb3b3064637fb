// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <source_location>
#include <string>
#include <utility>
#include <vector>

#include "checked/engine.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// What a statement says about one pair.
struct Outcome {
  enum class Kind { holds, fails, discarded };
  Kind kind = Kind::holds;
  std::string why;                            ///< what was seen, where it fails
  std::map<std::string, std::size_t> counts;  ///< how much was looked at, summed over a run
  std::optional<Point> at = {};  ///< in the plane of the sum, where it fails at a point

  /// Makes it a failure, for what was seen, at this point if there is one. Returns it.
  Outcome& fail(std::string what, std::optional<Point> where = {}) {
    kind = Kind::fails;
    why = std::move(what);
    at = std::move(where);
    return *this;
  }
};

/// A finite domain, gone through completely.
struct Enumeration {
  std::size_t cases = 0;
  std::string failure;  ///< the first case found false, in words; empty where all hold
};

/// A family whose pairs the statement is tried on.
struct Source {
  std::string family;
  std::size_t largest;  ///< the n that a run ends with; it starts with the smallest
  int weight;           ///< pairs are drawn from the sources in proportion
};

/// A class of pairs (`named(Classification)`, is_of_a_count()) and the least share of the cases in it.
struct Promise {
  std::string classification;
  int percent;
};

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

/// A statement of the thesis or a fact of our own, as something that can be found false.
struct Statement {
  std::string id;  ///< kind and number: "lemma-4.1.4"
  std::vector<Source> sources = {};
  std::vector<Promise> promises = {};
  std::vector<std::string> kills;  ///< mutants that the statement must find
  std::size_t cases = 0;           ///< how many a run tries unless told otherwise
  std::string file = std::source_location::current().file_name();  ///< where it stands
  /// Tried on pairs. May be empty where `enumerate` is not; then there are no sources, no promises
  /// and no cases.
  std::function<Outcome(const Summands&)> check = {};
  /// Proves the statement, or what it comes down to, case by case; empty where there is no finite
  /// domain.
  std::function<Enumeration()> enumerate = {};
  /// The same asked of one engine's sums, for statements that speak of sums only; throws what
  /// the engine throws. Empty for others.
  std::function<Outcome(const Engine&, Boundary, const Summands&)> of_engine = {};
  StatementText text = {};  ///< statements() adds it

  /// As kinds() in registry.cpp has them: lemma, theorem, ..., fact, law, step.
  std::string kind() const { return id.substr(0, id.find('-')); }
};

/// What the statement says of a pair; an exception is a failure too. Discarded without `check`.
Outcome evaluate(const Statement& statement, const Summands& summands);

/// Goes through all cases; none at all is a failure, and so is an exception.
/// Requires: the statement has an enumeration.
Enumeration enumerated(const Statement& statement);

}  // namespace oplus
