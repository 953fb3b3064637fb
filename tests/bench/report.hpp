// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/bench/row.hpp"

namespace oplus {

/// Where and how a run was made.
struct Setting {
  std::string processor = {};
  unsigned cores = 0;
  std::string compiler = {};
  std::string libraries = {};
  std::string commit = {};  ///< of the sources, as far as git knew it when the build was configured
  std::string command = {};
  double limit = 0;
  std::vector<std::string> missing = {};  ///< published pairs that were not there
};

/// A run.
struct Report {
  Setting setting = {};
  Rows rows = {};
};

/// That of this program on this machine.
Setting this_setting(const std::string& command, double limit);

/// JSON: what --json writes and --from reads, and what a measuring process says.
/// The readers throw std::invalid_argument where the text says something else.
std::string to_json(const Report& report);
std::string to_json(const Measurement& measurement);
Report report_of(const std::string& json);
Measurement measurement_of(const std::string& json);

}  // namespace oplus
