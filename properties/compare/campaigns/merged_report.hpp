// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace oplus {

/// Returns the report that one run without shards would have written, of the reports of all shards of
/// one campaign (sealed_report.hpp), each with the name of its file; a shard may be there more than
/// once with the same content. Throws InvalidInput where shards are missing, one is there twice with
/// different content or is not finished, or they are not of one campaign, command and version.
nlohmann::ordered_json merged_report(
    const std::vector<std::pair<std::string, nlohmann::ordered_json>>& reports);

/// Whether a report says that all is as it should be: what its command's exit code 0 says.
bool found_nothing(const nlohmann::ordered_json& report);

}  // namespace oplus
