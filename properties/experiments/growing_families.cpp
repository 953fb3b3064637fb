// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/growing_families.hpp"

#include <iostream>

#include "properties/experiments/engine_measurement.hpp"
#include "properties/experiments/engine_tables.hpp"

namespace oplus {

namespace {

std::size_t scaled(std::size_t largest, double scale) {
  return static_cast<std::size_t>(static_cast<double>(largest) * scale);
}

}  // namespace

std::vector<std::size_t> sizes(const SizeRange& range, double scale) {
  std::vector<std::size_t> result = {range.smallest};
  const std::size_t largest = scaled(range.largest, scale);
  while (result.back() + range.step <= largest) result.push_back(result.back() + range.step);
  return result;
}

std::vector<std::size_t> doubling_sizes(std::size_t smallest, std::size_t largest, double scale) {
  std::vector<std::size_t> result = {smallest};
  while (2 * result.back() <= scaled(largest, scale)) result.push_back(2 * result.back());
  return result;
}

Random random_of(const std::string& experiment, std::uint64_t seed, std::size_t size,
                 std::size_t index) {
  std::vector<std::uint32_t> material(experiment.begin(), experiment.end());
  for (const std::uint64_t number : {seed, std::uint64_t{size}, std::uint64_t{index}}) {
    material.push_back(static_cast<std::uint32_t>(number));
    material.push_back(static_cast<std::uint32_t>(number >> 32));
  }
  std::seed_seq mixed(material.begin(), material.end());  // the standard fixes what it gives
  return Random(mixed);
}

Table measured_family(const GrowingFamily& family, const ExperimentSettings& settings,
                      std::vector<std::string>& wrong) {
  Table table;
  table.columns = {"size", "pair"};
  for (const std::string& column : engine_columns()) table.columns.push_back(column);
  for (const std::size_t size : sizes(family.sizes, settings.scale)) {
    for (std::size_t index = 1; index <= family.pairs; ++index) {
      const auto make = [&] {
        Random random = random_of(family.name, settings.seed, size, index);
        return family.make(random, size);
      };
      Row row = measured_engines(make, settings.memory_limit_mb);
      row["size"] = size;
      row["pair"] = index;
      const std::string name =
          family.name + " " + std::to_string(size) + ", pair " + std::to_string(index);
      add_faults(row, name, wrong);
      std::cout << progress_line(name, row) << std::endl;
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace oplus
