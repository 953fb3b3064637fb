// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/published_pairs.hpp"

#include <filesystem>

#include "properties/runner/source_tree.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

namespace {

std::string path_of(const std::string& file) { return data_folder() / (file + ".dat"); }

}  // namespace

bool PublishedPair::is_there() const {
  return std::filesystem::exists(path_of(p)) && std::filesystem::exists(path_of(q));
}

Summands PublishedPair::read() const {
  Region first = read_region_file(path_of(p)).region;
  return {std::move(first), read_region_file(path_of(q)).region};
}

const std::vector<PublishedPair>& published_pairs() {
  static const std::vector<PublishedPair> all{
      {"cavity", {{0.001, 0.002, 161, 81}}},
      {"chain", {{0.025, 0.013, 2868, 801}}},
      {"comb", {{0.006, 0.009, 651, 579}}, "published comb"},
      {"conc_chain", {{0.017, 0.004, 3543, 74}}},
      {"fork", {{0.185, 0.322, 22063, 6154}}, "published fork"},
      {"knife", {{0.066, 0.028, 9749, 2946}}},
      {"rand3015", {{0.01, 0.005, 2309, 426}}},
      {"random", {{0.02, 0.01, 4698, 831}}},
      {"stars", {{0.031, 0.014, 5482, 791}}, "published stars"},
      {"isolated_vertex", {}, "published pair with an isolated vertex"},
      {"e_and_g", {}, "published E and G", "E", "G"},
      {"l_and_square", {}, "published L and square", "l_shape", "deg_square"},
      {"holes", {}, "published pair with holes", "pwh1", "pwh2"},
  };
  return all;
}

}  // namespace oplus
