// SPDX-License-Identifier: MIT
#include "reference/io/region_lines.hpp"

#include <sstream>

#include "reference/io/file_text.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

std::vector<Region> read_region_lines(const std::string& path) {
  std::vector<Region> regions;
  std::istringstream lines(input_text(path, "a file of regions, one a line"));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      regions.push_back(read_region(line, path).region);
    } catch (const InvalidInput& e) {
      throw InvalidInput({path, number, e.where().column}, e.wrong(), e.expected());
    }
  }
  if (regions.empty()) throw InvalidInput({path}, "it is empty", "regions, one a line");
  return regions;
}

}  // namespace oplus
