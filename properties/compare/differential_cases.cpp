// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/differential_cases.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

DifferentialCase named_case(const std::string& name, Summands summands) {
  const auto kept = std::make_shared<const Summands>(std::move(summands));
  return {name, "files", [kept] { return *kept; }};
}

Region read(const std::filesystem::path& file) { return read_region_file(file.string()).region; }

}  // namespace

std::size_t main_job_cases(const std::string& family) {
  static const std::map<std::string, std::size_t> counts = {{"grid", 4000},   {"holes", 600},
                                                            {"tight", 600},   {"components", 300},
                                                            {"islands", 300}, {"fork", 6}};
  const auto count = counts.find(family);
  return count == counts.end() ? 60 : count->second;
}

DifferentialCase case_of_files(const std::filesystem::path& p, const std::filesystem::path& q) {
  return named_case(p.string() + " " + q.string(), {read(p), read(q)});
}

std::vector<DifferentialCase> cases_of_folder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file() && format_of(entry.path().string())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<DifferentialCase> cases;
  std::vector<std::pair<std::string, Region>> others;
  for (const std::filesystem::path& file : files) {
    const std::string stem = file.stem().string();
    const auto partner = [&](const std::string& own, const std::string& wanted) {
      if (!stem.ends_with(own)) return files.end();
      const std::string name = stem.substr(0, stem.size() - own.size()) + wanted;
      return std::find_if(files.begin(), files.end(),
                          [&](const auto& other) { return other.stem() == name; });
    };
    const auto second = partner("_part1", "_part2");
    if (second != files.end())
      cases.push_back(
          named_case(stem + " " + second->stem().string(), {read(file), read(*second)}));
    else if (partner("_part2", "_part1") == files.end())
      others.emplace_back(stem, read(file));
  }
  for (std::size_t i = 0; i < others.size(); ++i) {
    for (std::size_t j = i; j < others.size(); ++j)
      cases.push_back(named_case(others[i].first + " " + others[j].first,
                                 {others[i].second, others[j].second}));
  }
  return cases;
}

std::vector<DifferentialCase> cases_of_family(const Family& family, std::size_t count,
                                              std::uint64_t seed,
                                              std::optional<std::size_t> largest) {
  const std::size_t end = std::max(largest.value_or(family.typical), family.smallest);
  std::vector<DifferentialCase> cases;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t n = family.smallest + i % (end - family.smallest + 1);
    // Neighbouring seeds of the engine give unrelated sequences: it mixes its seed.
    const std::uint64_t own_seed = seed * 1000003 + i;
    cases.push_back(
        {"gen " + family.name + " --n " + std::to_string(n) + " --seed " + std::to_string(own_seed),
         family.name, [&family, n, own_seed] { return generate(family, n, own_seed); }});
  }
  return cases;
}

}  // namespace oplus
