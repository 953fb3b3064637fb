// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "properties/fuzz/fuzz_target.hpp"

namespace oplus {

/// The result of an input in this build.
struct ShownInput {
  std::string text;  ///< lines for people
  bool is_a_finding = false;
};

/// Runs the target on an input. Of slide, the pair is written as two .dat files into a folder; it
/// is shrunk before, if it shows a finding. Throws std::system_error.
ShownInput shown(const FuzzTarget& target, std::string_view input,
                 const std::filesystem::path& folder);

}  // namespace oplus
