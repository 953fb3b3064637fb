// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/summand_files.hpp"

#include <stdlib.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

bool needs_no_quotes(const std::string& path) {
  return path.starts_with('/') && std::all_of(path.begin(), path.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || std::strchr("/._-", c) != nullptr;
         });
}

std::string new_folder() {
  std::error_code none;
  const std::string wanted = std::filesystem::temp_directory_path(none).string();
  std::string folder = (needs_no_quotes(wanted) ? wanted : "/tmp") + "/oplus-pair-XXXXXX";
  if (::mkdtemp(folder.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), folder);
  return folder;
}

void write_region(const std::string& path, const Region& region) {
  std::ofstream file(path, std::ios::binary);
  write(file, region, Format::wkt);
  if (!file.flush()) throw std::system_error(errno, std::generic_category(), path);
}

}  // namespace

SummandFiles::SummandFiles(const Region& p, const Region& q) : folder_(new_folder()) {
  try {
    write_region(this->p(), p);
    write_region(this->q(), q);
  } catch (...) {
    std::error_code none;
    std::filesystem::remove_all(folder_, none);
    throw;
  }
}

SummandFiles::~SummandFiles() {
  std::error_code none;
  std::filesystem::remove_all(folder_, none);
}

}  // namespace oplus
