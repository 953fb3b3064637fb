// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/corpus.hpp"

#include <fstream>
#include <stdexcept>
#include <utility>

#include "properties/runner/source_tree.hpp"

namespace oplus {

namespace {

std::vector<CorpusSets> all_rows() {
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

  std::vector<CorpusSets> rows;
  for (const std::vector<std::string>& block : blocks) {
    const auto field = [&](std::size_t i, const std::string& key) {
      if (i >= block.size() || !block[i].starts_with(key + ": "))
        throw std::runtime_error("row '" + block[0] + "': no field '" + key + "' in its place");
      return block[i].substr(key.size() + 2);
    };
    const std::string name = field(0, "name");
    const auto set = [&](std::size_t i, const std::string& key) {
      return read_set(field(i, key), name + ", " + key);
    };
    const auto sum = [&](std::size_t i, const std::string& key) {
      return read_sum(field(i, key), name + ", " + key).sum;
    };
    CorpusSets row{name, field(1, "story"), set(2, "P"), set(3, "Q"), sum(4, "closed"), {}};
    row.open = field(5, "open") == "same" ? row.closed : sum(5, "open");
    if (block.size() > 6) throw std::runtime_error("row '" + name + "': more than six fields");
    rows.push_back(std::move(row));
  }
  return rows;
}

bool is_of_regions(const CorpusSets& row) {
  return row.p.segments.empty() && row.p.points.empty() && row.q.segments.empty() &&
         row.q.points.empty();
}

}  // namespace

std::vector<CorpusPair> corpus() {
  std::vector<CorpusPair> pairs;
  for (const CorpusSets& row : all_rows())
    if (is_of_regions(row))
      pairs.push_back({row.name, row.story, row.p.region, row.q.region, row.closed, row.open});
  return pairs;
}

std::vector<CorpusSets> corpus_of_sets() {
  std::vector<CorpusSets> rows = all_rows();
  std::erase_if(rows, is_of_regions);
  return rows;
}

}  // namespace oplus
