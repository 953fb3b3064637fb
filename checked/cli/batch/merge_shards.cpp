// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/merge_shards.hpp"

#include <sys/resource.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "checked/cli/batch/job.hpp"
#include "checked/cli/batch/lasting_output.hpp"
#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

std::string name_of(std::size_t index, const Job& job) {
  return "shard " + std::to_string(index) + " of " + std::to_string(job.shard.of);
}

void require_complete(const std::string& file, const Job& job) {
  if (!job.bytes) throw UsageError(file + " is not complete; its command goes on with --resume");
  std::error_code missing;
  const std::uintmax_t bytes = std::filesystem::file_size(file, missing);
  if (missing) throw UsageError(file + " cannot be opened (" + missing.message() + ")");
  if (bytes != *job.bytes)
    throw UsageError(file + " is cut or was changed: it has " + counted(bytes, "byte", "bytes") +
                     ", and was complete with " + std::to_string(*job.bytes));
}

/// The files in the order of the shards.
std::vector<std::string> in_order(const std::vector<std::string>& files) {
  const Job first = read_job(files.front());
  std::map<std::size_t, std::string> by_index;
  for (const std::string& file : files) {
    const Job job = read_job(file);
    std::string other = difference(job, first);
    if (other.empty() && job.shard.of != first.shard.of)
      other =
          "it is " + name_of(job.shard.index, job) + ", not of " + std::to_string(first.shard.of);
    if (!other.empty())
      throw UsageError(file + " is of another job than " + files.front() + ": " + other);
    require_complete(file, job);
    if (const auto [same, is_new] = by_index.emplace(job.shard.index, file); !is_new)
      throw UsageError(same->second + " and " + file + " are both " +
                       name_of(job.shard.index, job));
  }
  std::vector<std::string> ordered;
  for (const auto& [index, file] : by_index) {
    if (index != ordered.size() + 1) break;
    ordered.push_back(file);
  }
  if (const std::size_t missing = first.shard.of - by_index.size(); missing > 0)
    throw UsageError(name_of(ordered.size() + 1, first) + " is missing" +
                     (missing > 1 ? "; so are " + std::to_string(missing - 1) + " more" : ""));
  return ordered;
}

/// All of them are open at once: as many as the system allows.
void allow_many_files() {
  rlimit files{};
  if (getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
}

}  // namespace

Results merge_shards(std::vector<std::string> shards, const std::string& output) {
  shards = in_order(shards);
  allow_many_files();
  std::vector<std::ifstream> files;
  for (const std::string& shard : shards) {
    files.emplace_back(shard, std::ios::binary);
    if (!files.back()) throw UsageError(shard + " cannot be opened (" + std::strerror(errno) + ")");
  }
  CommandOutput merged(output);
  Results counts;
  std::string block, line;
  for (std::size_t i = 0; std::getline(files[i % files.size()], line); ++i) {
    count_line(counts, line, shards[i % shards.size()]);
    block += line;
    block += '\n';
    if (block.size() < 1 << 16) continue;
    merged.write(block);
    block.clear();
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].bad()) throw UsageError(shards[i] + " cannot be read");
    if (files[i].peek() != std::ifstream::traits_type::eof())
      throw UsageError(shards[i] + " has more lines than the other shards");
  }
  merged.write(block);
  merged.finish();
  return counts;
}

}  // namespace oplus
