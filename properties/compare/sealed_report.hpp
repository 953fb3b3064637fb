// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "properties/compare/shard.hpp"

namespace oplus {

/// A report that can be merged with those of the other shards of its campaign. An object with
///  1. "report": the command that wrote it; "version": that of oplus;
///  2. "campaign": an object, the same for all shards: all that decides what is run;
///  3. "shard", "shards": which of them it is;
///  4. what the command reports: counts and findings, nothing of time and place;
///  5. "checksum": of all that.

/// Returns the first three, to which the rest is added.
nlohmann::ordered_json begun_report(const std::string& command,
                                    const nlohmann::ordered_json& campaign, const Shard& shard);

/// Returns the text of a report, with its checksum.
std::string sealed(const nlohmann::ordered_json& report);

/// Returns the report of a text, the checksum left out. Throws InvalidInput where the text is none or
/// its checksum is not that of the rest; `file` is what messages call it.
nlohmann::ordered_json opened(const std::string& text, const std::string& file);

}  // namespace oplus
