// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/question_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <system_error>

namespace oplus::smt {

QuestionFolder::QuestionFolder(const std::string& named) : path_(named), stays_(!named.empty()) {
  if (stays_) {
    std::filesystem::create_directories(path_);
    return;
  }
  std::string folder = (std::filesystem::temp_directory_path() / "oplus-smt-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), folder);
  path_ = folder;
}

QuestionFolder::~QuestionFolder() {
  std::error_code none;
  if (!stays_) std::filesystem::remove_all(path_, none);
}

}  // namespace oplus::smt
