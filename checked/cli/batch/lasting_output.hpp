// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "checked/cli/batch/job.hpp"
#include "checked/cli/batch/results.hpp"
#include "checked/cli/command_line/outputs.hpp"

namespace oplus {

/// A file that no other FileLock has as long as this one lives. It is made if it does not exist.
class FileLock {
 public:
  /// Throws UsageError, also where another one has it.
  explicit FileLock(const std::string& path);
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

 private:
  int descriptor_;
};

/// Where the lines of a batch go. One that resumes extends its file at once, and keeps the lines that are there
/// if they are of its job:
///  1. what stands behind the last end of a line is dropped;
///  2. the last line that is kept is computed again, and must come out as it is;
///  3. a refusal leaves the file as it was.
class LastingOutput {
 public:
  /// `job` is there if the output has one, and always if it resumes. Throws UsageError, also where another process
  /// resumes the same file.
  /// Requires: the output of a job is a file.
  LastingOutput(const std::string& path, std::optional<Job> job, bool resumes);

  /// How many lines need not be written any more. The first one that is written is the last one that is kept, if
  /// there is one.
  std::size_t lines_done() const { return counts_.pairs; }

  /// The counts of these.
  const Results& counts() const { return counts_; }

  void write(std::string_view lines);
  void finish();

 private:
  void keep_lines();
  void begin();

  std::string path_;
  std::optional<Job> job_;
  std::unique_ptr<FileLock> lock_;
  Results counts_;
  std::size_t bytes_kept_ = 0;
  std::string last_line_;  ///< of those kept, until it was compared
  std::optional<CommandOutput> output_;
};

/// Counts a line of an output. Throws UsageError, which names the file, where it is not one.
void count_line(Results& counts, const std::string& line, const std::string& file);

}  // namespace oplus
