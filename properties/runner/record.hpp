// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/runner/kill.hpp"

namespace oplus {

/// What a run of `properties` did, as docs/theorems/ keeps it: same seed, same program, same record.
struct RecordedRun {
  std::string statement;
  std::optional<std::size_t> enumerated = {};  ///< cases of the enumeration, all of which hold
  std::size_t run = 0;
  std::size_t discarded = 0;
  std::map<std::string, std::size_t> families = {};
  std::map<std::string, std::size_t> classes = {};
  std::map<std::string, std::size_t> counts = {};
  std::optional<Summands> typical = {};
};

/// Requires: the run has passed.
RecordedRun recorded(const Statement& statement, const PropertyRun& run);

/// JSON, an object a line, pairs as WKT.
std::string to_json(const std::vector<RecordedRun>& runs);
std::string to_json(const std::vector<Kill>& kills);

/// Throw InvalidInput; `file` is what messages call the text.
std::vector<RecordedRun> runs_of_json(const std::string& text, const std::string& file);
std::vector<Kill> kills_of_json(const std::string& text, const std::string& file);

}  // namespace oplus
