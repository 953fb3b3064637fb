// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/families.hpp"

#include <random>

namespace oplus {

std::vector<std::size_t> sizes(const SizeRange& range, double scale) {
  const auto largest = static_cast<std::size_t>(static_cast<double>(range.largest) * scale);
  std::vector<std::size_t> result;
  std::size_t size = range.smallest;
  do {
    result.push_back(size);
    size += range.step == 0 ? size : range.step;
  } while (size <= largest);
  return result;
}

Random random_of(const std::string& experiment, std::uint64_t seed, std::size_t size) {
  constexpr std::uint64_t index = 1;  // one pair per size, where the thesis has 5 or 20
  std::vector<std::uint32_t> material(experiment.begin(), experiment.end());
  for (const std::uint64_t number : {seed, std::uint64_t{size}, index}) {
    material.push_back(static_cast<std::uint32_t>(number));
    material.push_back(static_cast<std::uint32_t>(number >> 32));
  }
  std::seed_seq mixed(material.begin(), material.end());  // its output is fixed by the standard
  return Random(mixed);
}

Row random_row(const std::string& experiment, std::uint64_t seed, std::size_t size,
               const std::function<Summands(Random& random, std::size_t size)>& make) {
  const auto make_it = [=] {
    Random random = random_of(experiment, seed, size);
    return std::vector<Summands>{make(random, size)};
  };
  return {.name = experiment + " " + std::to_string(size),
          .group = experiment,
          .what = "size " + std::to_string(size),
          .make = make_it,
          .numbers = {{"size", static_cast<double>(size)}, {"pair", 1}}};
}

}  // namespace oplus
