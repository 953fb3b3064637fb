// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/families.hpp"

#include <random>

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

Row random_row(const std::string& experiment, std::uint64_t seed, std::size_t size,
               const std::function<Summands(Random& random, std::size_t size)>& make) {
  constexpr std::size_t only_one = 1;  // of each size, where the thesis has 5 or 20
  Row row;
  row.name = experiment + " " + std::to_string(size);
  row.group = experiment;
  row.what = "size " + std::to_string(size);
  row.numbers = {{"size", static_cast<double>(size)}, {"pair", 1}};
  row.make = [=] {
    Random random = random_of(experiment, seed, size, only_one);
    return std::vector<Summands>{make(random, size)};
  };
  return row;
}

}  // namespace oplus
