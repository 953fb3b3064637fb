// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>

#include "reference/io/output_file.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(int error, const fs::path& path) {
  throw std::system_error(error, std::generic_category(), "cannot write " + path.string());
}

void write_all(int descriptor, std::string_view content, const fs::path& path) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR) fail(errno, path);
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Names of temporary files that are there. A command has few outputs; more than these are not noted.
using Name = const fs::path::value_type*;
std::array<std::atomic<Name>, 16> temporary_files;
static_assert(std::atomic<Name>::is_always_lock_free);

/// Replaces one entry, if there is one.
void replace(Name entry, Name by) {
  for (std::atomic<Name>& one : temporary_files) {
    Name expected = entry;
    if (one.compare_exchange_strong(expected, by)) return;
  }
}

}  // namespace

/// Where text goes.
class OutputFile::Target {
 public:
  Target() = default;
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  virtual ~Target() = default;
  virtual void write(std::string_view text) = 0;
  virtual void finish() = 0;

  class Temporary;
  class InPlace;
  class StandardOutput;
};

/// A file beside the target that is gone with this object unless it has become the target.
class OutputFile::Target::Temporary : public Target {
 public:
  explicit Temporary(const fs::path& target) : target_(target) {
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
      path_ = target;
      path_ += '.' + std::to_string(::getpid()) + '-' + std::to_string(attempt) + ".tmp";
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) fail(errno, target_);
    }
    replace(nullptr, path_.c_str());
  }
  ~Temporary() override {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!is_target_) ::unlink(path_.c_str());
    replace(path_.c_str(), nullptr);
  }

  void write(std::string_view text) override { write_all(descriptor_, text, target_); }

  void finish() override {
    std::error_code failed;
    if (const fs::file_status old = fs::status(target_, failed); fs::exists(old))
      fs::permissions(path_, old.permissions(), failed);
    else
      failed.clear();
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(errno, target_);
    if (!failed) fs::rename(path_, target_, failed);
    if (failed) fail(failed.default_error_condition().value(), target_);
    is_target_ = true;
  }

 private:
  fs::path target_;
  fs::path path_;
  int descriptor_ = -1;
  bool is_target_ = false;
};

class OutputFile::Target::StandardOutput : public Target {
 public:
  void write(std::string_view text) override {
    errno = 0;
    std::cout << text << std::flush;
    if (!std::cout) fail(errno != 0 ? errno : EIO, "standard output");
  }
  void finish() override {}
};

/// A device or a pipe is written to, never replaced; nor is a file that is extended.
class OutputFile::Target::InPlace : public Target {
 public:
  explicit InPlace(const fs::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) {
    if (descriptor_ < 0) fail(errno, path_);
  }
  ~InPlace() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  void write(std::string_view text) override { write_all(descriptor_, text, path_); }

  void finish() override {
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(errno, path_);
  }

 private:
  fs::path path_;
  int descriptor_;
};

OutputFile::OutputFile(const std::string& path, Regular regular) {
  std::error_code ignored;
  if (path == "-")
    target_ = std::make_unique<Target::StandardOutput>();
  else if (!is_replaced(path) || regular == Regular::extended)
    target_ = std::make_unique<Target::InPlace>(path);
  else  // A link stays a link: the file it leads to is replaced.
    target_ = std::make_unique<Target::Temporary>(
        fs::is_symlink(fs::symlink_status(path, ignored)) && fs::exists(path, ignored)
            ? fs::canonical(path)
            : fs::path(path));
}

OutputFile::~OutputFile() = default;

void OutputFile::write(std::string_view text) { target_->write(text); }

void OutputFile::finish() { target_->finish(); }

bool OutputFile::is_replaced(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return path != "-" && (!fs::exists(status) || fs::is_regular_file(status));
}

void remove_temporary_files() noexcept {
  for (const std::atomic<Name>& one : temporary_files)
    if (const Name path = one) ::unlink(path);
}

void write_file(const std::string& path, const std::string& content) {
  OutputFile file(path);
  file.write(content);
  file.finish();
}

}  // namespace oplus
