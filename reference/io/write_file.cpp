// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(int error, const std::string& path) {
  throw std::system_error(error, std::generic_category(), "cannot write " + path);
}

void write_all(int descriptor, std::string_view content, const std::string& path) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR) fail(errno, path);
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// A file beside the target that is gone with this object unless it has become the target.
class Temporary {
 public:
  explicit Temporary(const fs::path& target) : target_(target) {
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
      path_ = target;
      path_ += '.' + std::to_string(::getpid()) + '-' + std::to_string(attempt) + ".tmp";
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) fail(errno, target_);
    }
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!is_target_) ::unlink(path_.c_str());
  }

  void write(std::string_view content) const { write_all(descriptor_, content, target_); }

  void become_target() {
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0 && ::fchmod(descriptor_, old.st_mode & 07777U) != 0)
      fail(errno, target_);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0 || ::rename(path_.c_str(), target_.c_str()) != 0) fail(errno, target_);
    is_target_ = true;
  }

 private:
  fs::path target_;
  fs::path path_;
  int descriptor_ = -1;
  bool is_target_ = false;
};

void write_standard_output(const std::string& content) {
  errno = 0;
  std::cout << content << std::flush;
  if (!std::cout) fail(errno != 0 ? errno : EIO, "standard output");
}

/// A device or a pipe is written to, never replaced.
void write_in_place(const std::string& path, const std::string& content) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(errno, path);
  try {
    write_all(descriptor, content, path);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0) fail(errno, path);
}

}  // namespace

void write_file(const std::string& path, const std::string& content) {
  if (path == "-") return write_standard_output(content);
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(path, content);
  // A link stays a link: the file it leads to is replaced.
  Temporary file(fs::is_symlink(fs::symlink_status(path, ignored)) && fs::exists(status)
                     ? fs::canonical(path)
                     : fs::path(path));
  file.write(content);
  file.become_target();
}

}  // namespace oplus
