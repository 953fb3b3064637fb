// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "checked/cli/batch/results.hpp"

namespace oplus {

/// Writes what one run would have written, from the outputs of all shards of a job, in any order: one line of each
/// in turn. Returns the counts of the lines. Holds one line at a time. Throws UsageError, before it writes, where a
/// shard is missing, there twice, not complete, or of another job.
Results merge_shards(std::vector<std::string> shards, const std::string& output);

}  // namespace oplus
