// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/summand_files.hpp"

#include <system_error>

#include "properties/runner/finding.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::filesystem::path folder_that_needs_no_quotes() {
  std::error_code none;
  const std::filesystem::path wanted = std::filesystem::temp_directory_path(none);
  return wanted.is_absolute() && for_shell(wanted) == wanted ? wanted : "/tmp";
}

}  // namespace

SummandFiles::SummandFiles(const Region& p, const Region& q)
    : folder_("oplus-pair", folder_that_needs_no_quotes()) {
  write_file(this->p(), written(p, Format::wkt));
  write_file(this->q(), written(q, Format::wkt));
}

}  // namespace oplus
