// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "properties/fuzz/fuzz_target.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// The pair that an input of the target slide stands for; nullopt where it is rejected.
std::optional<Summands> pair_of_input(std::string_view bytes);

/// The inverse: nullopt where such a pair has no plan (pair_plan.hpp).
std::optional<std::string> input_of_pair(const Summands& summands);

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
