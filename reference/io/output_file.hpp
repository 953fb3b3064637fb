// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace oplus {

/// Text on its way into a file, part by part. A regular file is there as a whole or not at all: parts go to
/// a temporary one beside it, which finish() renames; without finish() it is removed. "-" is standard output.
/// This, a device and another special file are written to at once, and never replaced.
class OutputFile {
 public:
  /// Throws std::system_error.
  explicit OutputFile(const std::string& path);
  ~OutputFile();

  /// Appends. Throws std::system_error.
  void write(std::string_view text);

  /// To be called once, after all is written. Throws std::system_error.
  void finish();

 private:
  class Target;
  std::unique_ptr<Target> target_;
};

}  // namespace oplus
