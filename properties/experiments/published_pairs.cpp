// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/published_pairs.hpp"

#include "reference/io/reading.hpp"

namespace oplus {

namespace {

std::filesystem::path file(const PublishedPair& pair, const std::string& part) {
  return published_folder() / (pair.name + part + ".dat");
}

}  // namespace

const std::vector<PublishedPair>& published_pairs() {
  static const std::vector<PublishedPair> pairs = {
      {"cavity", 0.001, 0.002, 161, 81},    {"chain", 0.025, 0.013, 2868, 801},
      {"comb", 0.006, 0.009, 651, 579},     {"conc_chain", 0.017, 0.004, 3543, 74},
      {"fork", 0.185, 0.322, 22063, 6154},  {"knife", 0.066, 0.028, 9749, 2946},
      {"rand3015", 0.01, 0.005, 2309, 426}, {"random", 0.02, 0.01, 4698, 831},
      {"stars", 0.031, 0.014, 5482, 791},
  };
  return pairs;
}

std::filesystem::path published_folder() { return OPLUS_DATA_DIR; }

bool is_there(const PublishedPair& pair) {
  return std::filesystem::exists(file(pair, "_part1")) &&
         std::filesystem::exists(file(pair, "_part2"));
}

Summands read(const PublishedPair& pair) {
  Region p = read_region_file(file(pair, "_part1").string()).region;
  return {std::move(p), read_region_file(file(pair, "_part2").string()).region};
}

}  // namespace oplus
