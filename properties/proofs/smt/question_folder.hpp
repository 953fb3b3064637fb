// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace oplus::smt {

/// Where the questions are written: the folder that is named, which stays, or one that goes with it.
class QuestionFolder {
 public:
  /// Throws std::system_error.
  explicit QuestionFolder(const std::string& named);
  QuestionFolder(const QuestionFolder&) = delete;
  QuestionFolder& operator=(const QuestionFolder&) = delete;
  ~QuestionFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool stays_;
};

}  // namespace oplus::smt
