// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace oplus {

/// What one run of a fuzz program printed.
struct FuzzReport {
  std::string target;
  std::size_t runs = 0;
  std::size_t edges = 0;     ///< of the control flow, covered
  std::size_t reached = 0;   ///< inputs that were valid for the target,
  std::size_t rejected = 0;  ///< and that were not; both are unknown where a finding ended the run
  std::string finding;       ///< a line, or empty
  std::string input;         ///< the file with the input that shows it
};

/// Reads what libFuzzer and the target wrote. A run that stopped early without a finding is a finding,
/// too: the program could not be run.
FuzzReport report_of(const std::string& target, std::string_view log, bool ended_well);

/// "slide    1000 runs, 7237 edges, 941 of 1000 inputs reached, no finding"
std::string line_of(const FuzzReport& report);

nlohmann::json to_json(const FuzzReport& report);

}  // namespace oplus
