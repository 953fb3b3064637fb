// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "properties/fuzz/fuzz_report.hpp"

namespace oplus {

/// How a target's program is run.
struct FuzzRun {
  std::filesystem::path program;
  std::string target;
  std::size_t longest;           ///< input, in bytes
  std::size_t seconds = 0;       ///< 0: no limit
  std::size_t runs = 0;          ///< 0: no limit
  std::uint32_t seed = 1;        ///< not 0, which libFuzzer takes from the clock
  std::filesystem::path corpus;  ///< inputs that showed something new are kept here
  std::filesystem::path seeds;   ///< read; left out where there is no such folder
  std::filesystem::path dictionary;
  std::filesystem::path out;  ///< for the log and inputs that show a finding
};

/// Runs it, waits for it, and keeps what it writes in OUT/TARGET.log. Makes the folders.
/// Throws std::system_error where it can't be started.
FuzzReport run(const FuzzRun& wanted);

}  // namespace oplus
