// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/lasting_output.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "checked/cli/batch/computation.hpp"
#include "checked/cli/usage_error.hpp"

namespace oplus {

FileLock::FileLock(const std::string& path)
    : descriptor_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) throw UsageError("cannot write " + path + ": " + std::strerror(errno));
  // A file system without locks has no such guard.
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw UsageError("another oplus is writing " + path);
}

FileLock::~FileLock() { ::close(descriptor_); }

LastingOutput::LastingOutput(const std::string& path, std::optional<Job> job, bool resumes)
    : path_(path), job_(std::move(job)) {
  if (!resumes) {
    output_.emplace(path);
    return;
  }
  lock_ = std::make_unique<FileLock>(path);
  if (std::filesystem::file_size(path) > 0)
    keep_lines();
  else
    write_job(*job_, path);
}

void LastingOutput::keep_lines() {
  const Job before = read_job(path_);
  std::string other = difference(before, *job_);
  if (other.empty() && before.shard != job_->shard) other = "it is of another shard";
  if (!other.empty()) throw UsageError(path_ + " is the output of another job: " + other);
  std::ifstream in(path_, std::ios::binary);
  for (std::string line; std::getline(in, line) && !in.eof(); last_line_.swap(line)) {
    line += '\n';
    bytes_kept_ += last_line_.size();
    if (!last_line_.empty()) count_line(counts_, last_line_, path_);
  }
  if (in.bad()) throw UsageError(path_ + " cannot be read");
  // With more memory it may come out better.
  if (last_line_.find(without_memory) != std::string::npos) last_line_.clear();
}

void LastingOutput::begin() {
  if (output_) return;
  if (!last_line_.empty())
    throw UsageError(path_ + " is the output of another job: its last line, " +
                     std::to_string(counts_.pairs + 1) + ", comes out differently");
  std::filesystem::resize_file(path_, bytes_kept_);
  output_.emplace(path_, OutputFile::Regular::extended);
}

void LastingOutput::write(std::string_view lines) {
  if (lines.empty()) return;
  if (lines.starts_with(last_line_)) {
    bytes_kept_ += last_line_.size();
    lines.remove_prefix(last_line_.size());
    last_line_.clear();
  }
  begin();
  output_->write(lines);
}

void LastingOutput::finish() {
  begin();
  output_->finish();
  if (!job_) return;
  job_->bytes = std::filesystem::file_size(path_);
  write_job(*job_, path_);
}

void count_line(Results& counts, const std::string& line, const std::string& file) {
  ++counts.pairs;
  const auto refuse = [&] {
    throw UsageError(file + " has a line that oplus batch did not write");
  };
  if (!line.starts_with('{')) refuse();
  // Few lines have one, or an id that looks like it.
  if (line.find("\"error\": \"") == std::string::npos) return;
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (json.is_discarded()) refuse();
  if (const auto error = json.find("error"); error != json.end() && error->is_string())
    count_error(counts, *error);
}

}  // namespace oplus
