// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "checked/cli/shard.hpp"

namespace oplus {

/// What an output of `oplus batch` is of. A file beside the output says it where that may be gone on with, or be
/// merged with others: FILE.oplus-job, a line of JSON (docs/json.md).
struct Job {
  std::string oplus;                  ///< the version that computes
  std::vector<std::string> options;   ///< as they were given, with the names of the inputs
  std::vector<std::string> contents;  ///< the length and a checksum of each input
  Shard shard = {};
  std::optional<std::size_t> bytes = {};  ///< of the output; none as long as it is not complete
};

/// The job with these options, and inputs, which are files that can be read again. Throws UsageError where one is not.
Job job_of(std::vector<std::string> options, const std::vector<std::string>& inputs,
           const Shard& shard);

/// What tells one job from another, shards apart: "its options are ..., not ...". Empty for one job.
std::string difference(const Job& job, const Job& other);

/// The job of an output. Throws UsageError where it has none.
Job read_job(const std::string& output);

/// Throws UsageError.
void write_job(const Job& job, const std::string& output);

}  // namespace oplus
