// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/temporary_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <system_error>

namespace oplus {

TemporaryFolder::TemporaryFolder(const std::string& name, const std::filesystem::path& parent) {
  std::string folder = (parent / (name + "-XXXXXX")).string();
  if (::mkdtemp(folder.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), folder);
  path_ = folder;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code none;
  std::filesystem::remove_all(path_, none);
}

}  // namespace oplus
