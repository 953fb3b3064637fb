// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/sources.hpp"

#include <algorithm>

#include "properties/compare/grid_polygons.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/region_lines.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Region read(const std::filesystem::path& file, Extent extent = Extent::bounded) {
  return read_region_file(file.string(), {}, extent).region;
}

}  // namespace

Task pair_of_files(const std::filesystem::path& p, const std::filesystem::path& q, Extent extent) {
  return {p.string() + " " + q.string(), {read(p, extent), read(q, extent)}};
}

std::vector<Task> pairs_of_folder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file() && format_of(entry.path().string())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Task> pairs;
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
      pairs.push_back({stem + " " + second->stem().string(), {read(file), read(*second)}});
    else if (partner("_part2", "_part1") == files.end())
      others.emplace_back(stem, read(file));
  }
  for (std::size_t i = 0; i < others.size(); ++i) {
    for (std::size_t j = i; j < others.size(); ++j)
      pairs.push_back(
          {others[i].first + " " + others[j].first, {others[i].second, others[j].second}});
  }
  return pairs;
}

TaskSource given_source(std::vector<Task> tasks) {
  const std::size_t count = tasks.size();
  return {"files", "files", count,
          [tasks = std::move(tasks)](std::size_t i) { return tasks.at(i); }};
}

Task generated_pair(const Family& family, std::size_t n, std::uint64_t seed) {
  return {"gen " + family.name + " --n " + std::to_string(n) + " --seed " + std::to_string(seed),
          generate(family, n, seed)};
}

TaskSource family_source(const Family& family, std::size_t count, std::uint64_t seed,
                         std::optional<std::size_t> largest) {
  const std::size_t end = std::max(largest.value_or(family.typical), family.smallest);
  return {"families", family.name, count, [&family, seed, end](std::size_t i) {
            const std::size_t n = family.smallest + i % (end - family.smallest + 1);
            // Neighbouring seeds of the engine give unrelated sequences: it mixes its seed.
            return generated_pair(family, n, seed * 1000003 + i);
          }};
}

TaskSource grid_source(int side, std::size_t most_vertices, std::size_t most_pairs) {
  const auto polygons =
      std::make_shared<const std::vector<GridPolygon>>(grid_polygons(side, most_vertices));
  const auto orbits = std::make_shared<const std::vector<std::pair<std::uint32_t, std::uint32_t>>>(
      pair_orbits(*polygons));
  const std::size_t all = orbits->size(), wanted = std::min(most_pairs, all);
  const std::string points = std::to_string(side) + " x " + std::to_string(side) + " points";
  std::string name = std::to_string(polygons->size()) + " polygons of 3 to " +
                     std::to_string(most_vertices) + " vertices on " + points;
  if (wanted < all) name += ", " + std::to_string(wanted) + " of " + counted(all, "pair", "pairs");
  return {"grids", name, wanted, [=](std::size_t k) -> Task {
            const std::size_t index = k * all / wanted;
            const auto [i, j] = (*orbits)[index];
            return {"pair " + std::to_string(index) + " of exhaustive --grid " +
                        std::to_string(side) + " --vertices " + std::to_string(most_vertices),
                    {region_of((*polygons)[i]), region_of((*polygons)[j])}};
          }};
}

TaskSource parts_source(const std::filesystem::path& file) {
  const auto parts = std::make_shared<const std::vector<Region>>(read_region_lines(file));
  const std::size_t n = parts->size();
  return {"parts", file.stem(), n * n, [=, name = file.stem().string()](std::size_t i) -> Task {
            return {name + ", P is part " + std::to_string(i / n + 1) + " and -Q part " +
                        std::to_string(i % n + 1),
                    {parts->at(i / n), reflected(parts->at(i % n))}};
          }};
}

std::vector<TaskSource> corpus_sources() {
  std::vector<TaskSource> sources;
  for (const CorpusPair& pair : corpus()) {
    const auto known = std::make_shared<const CorpusPair>(pair);
    sources.push_back({"corpus", pair.name, 2, [known](std::size_t i) -> Task {
                         if (i == 0) return {known->name, {known->p, known->q}, known};
                         return {known->name + ", exchanged", {known->q, known->p}, known};
                       }});
  }
  return sources;
}

}  // namespace oplus
