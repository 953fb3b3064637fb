// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/bench/row.hpp"

namespace oplus {

/// The machine and the command of a run.
struct Setting {
  std::string processor = {};
  unsigned cores = 0;
  std::string compiler = {};
  std::string libraries = {};
  std::string commit = {};   ///< of the sources when the build was configured
  std::string command = {};  ///< without paths, which are of one machine only
  double limit = 0;
  std::vector<std::string> missing = {};  ///< missing published pairs
};

/// A run.
struct Report {
  Setting setting = {};
  Rows rows = {};
};

/// The setting of this program on this machine.
Setting this_setting(const std::string& command, double limit);

/// JSON: what --json writes and --from reads, and the output of a measuring process.
/// The readers throw std::invalid_argument if the text is something else.
std::string to_json(const Report& report);
std::string to_json(const Measurement& measurement);
Report report_of(const std::string& json);
Measurement measurement_of(const std::string& json);

}  // namespace oplus
