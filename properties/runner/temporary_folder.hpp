// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace oplus {

/// A new, empty folder that is removed with its contents when its owner is destroyed.
class TemporaryFolder {
 public:
  /// Its name starts with `name`. Throws std::system_error.
  explicit TemporaryFolder(
      const std::string& name = "oplus",
      const std::filesystem::path& parent = std::filesystem::temp_directory_path());
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace oplus
