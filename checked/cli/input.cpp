// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/input.hpp"

#include <algorithm>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

Region read_summand(const std::string& path) {
  ReadRegion read = read_region_file(path);
  for (const std::string& note : read.notes) say_note(note);
  return std::move(read.region);
}

MinkowskiSum read_given_sum(const std::string& path) {
  ReadSum read = read_sum_file(path);
  for (const std::string& note : read.notes) say_note(note);
  return std::move(read.sum);
}

void require_one_standard_input(const std::vector<std::string>& paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1)
    throw UsageError("standard input (-) can be read only once; give the others as files");
}

}  // namespace oplus
