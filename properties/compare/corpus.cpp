// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/corpus.hpp"

#include <fstream>
#include <stdexcept>
#include <utility>

#include "properties/runner/source_tree.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

std::vector<CorpusPair> corpus() {
  std::ifstream file(source_root() / "tests/corpus/pairs.txt");
  if (!file) throw std::runtime_error("cannot open tests/corpus/pairs.txt");
  std::vector<std::vector<std::string>> blocks(1);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    if (line.empty())
      blocks.emplace_back();
    else if (line.starts_with(' ') && !blocks.back().empty())
      blocks.back().back() += line;
    else
      blocks.back().push_back(line);
  }
  std::erase_if(blocks, [](const auto& block) { return block.empty(); });

  std::vector<CorpusPair> pairs;
  for (const std::vector<std::string>& block : blocks) {
    const auto field = [&](std::size_t i, const std::string& key) {
      if (i >= block.size() || !block[i].starts_with(key + ": "))
        throw std::runtime_error("row '" + block[0] + "': no field '" + key + "' in its place");
      return block[i].substr(key.size() + 2);
    };
    const std::string name = field(0, "name");
    const auto region = [&](std::size_t i, const std::string& key) {
      return read_region(field(i, key), name + ", " + key).region;
    };
    const auto sum = [&](std::size_t i, const std::string& key) {
      return read_sum(field(i, key), name + ", " + key).sum;
    };
    CorpusPair row{name, field(1, "story"), region(2, "P"), region(3, "Q"), sum(4, "closed"), {}};
    row.open = field(5, "open") == "same" ? row.closed : sum(5, "open");
    if (block.size() > 6) throw std::runtime_error("row '" + name + "': more than six fields");
    pairs.push_back(std::move(row));
  }
  return pairs;
}

}  // namespace oplus
