// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "reference/families/family.hpp"

namespace oplus {

/// Seed of a statement's run, so that no two statements receive the same pairs.
std::uint64_t seed_of(const std::string& id, std::uint64_t seed);

/// A pair on disk.
struct Finding {
  std::filesystem::path p;
  std::filesystem::path q;
};

/// Writes a pair as two .dat files into a folder, which is made if need be. The names carry the
/// statement and a hash of the pair, so that findings do not overwrite each other.
/// Throws std::system_error.
Finding write_finding(const std::filesystem::path& folder, const std::string& statement,
                      const Summands& summands);

/// The text as one word of a shell's line: quoted where it has to be.
std::string for_shell(const std::string& text);

/// The line that tries the statement on just that pair, quoted for a shell.
std::string replay_line(const std::string& statement, const Finding& finding);

}  // namespace oplus
