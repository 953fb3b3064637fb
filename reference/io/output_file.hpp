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
  /// Where text goes that is written to a regular file.
  enum class Regular {
    replaced,  ///< into a new file, which is there as a whole or not at all; the default
    extended,  ///< at once behind what the file contains
  };

  /// Throws std::system_error.
  explicit OutputFile(const std::string& path, Regular regular = Regular::replaced);
  ~OutputFile();

  /// Appends. Throws std::system_error.
  void write(std::string_view text);

  /// To be called once, after all is written. Throws std::system_error.
  void finish();

  /// Whether nothing is seen of a file before finish(): not "-", nor a device.
  static bool is_replaced(const std::string& path);

 private:
  class Target;
  std::unique_ptr<Target> target_;
};

/// Removes the temporary files of all OutputFiles: for a program that ends without destructors. May be called
/// in a signal handler.
void remove_temporary_files() noexcept;

}  // namespace oplus
