// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "properties/proofs/smt/run.hpp"

namespace oplus::smt {

/// A query in words: what pages show.
nlohmann::ordered_json to_json(const Query& query);

nlohmann::ordered_json to_json(const Model& model);

/// Throws nlohmann::json::exception or std::invalid_argument on invalid input.
Model model_of_json(const nlohmann::ordered_json& json);

/// The same with what each solver answered, without times, so that each run gives the same text;
/// the counterexamples, by the names of the dropped hypotheses, are Z3's models of the twins.
nlohmann::ordered_json to_json(const Query& query, const QueryRun& run);

/// What properties/proofs/smt/results.json holds: {"queries": [...]}.
nlohmann::ordered_json record_of(const std::vector<Query>& queries,
                                 const std::vector<QueryRun>& runs);

/// A line: the id, what each solver answered to each question, and how long that took.
std::string line_of(const QueryRun& run);

}  // namespace oplus::smt
