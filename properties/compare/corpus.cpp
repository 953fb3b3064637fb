// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/corpus.hpp"

#include <fstream>
#include <stdexcept>
#include <utility>

#include "properties/runner/source_tree.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

std::vector<CorpusPair> corpus() {
  std::ifstream in(source_root() / "tests/corpus/pairs.txt");
  if (!in) throw std::runtime_error("cannot open tests/corpus/pairs.txt");
  std::vector<std::vector<std::string>> blocks(1);
  for (std::string line; std::getline(in, line);) {
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
    CorpusPair row;
    row.name = field(0, "name");
    row.story = field(1, "story");
    const std::string open = field(5, "open");
    row.p = read_region(field(2, "P"), row.name + ", P").region;
    row.q = read_region(field(3, "Q"), row.name + ", Q").region;
    row.closed = read_sum(field(4, "closed"), row.name + ", closed").sum;
    row.open = open == "same" ? row.closed : read_sum(open, row.name + ", open").sum;
    if (block.size() > 6) throw std::runtime_error("row '" + row.name + "': more than six fields");
    pairs.push_back(std::move(row));
  }
  return pairs;
}

}  // namespace oplus
