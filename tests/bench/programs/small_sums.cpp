// SPDX-License-Identifier: GPL-3.0-or-later
// small-sums FILE: what tests/bench/python_calls.py times, in C++. FILE has two lines of WKT a pair. Prints the
// processor time of a sum in microseconds: of regions, and of these made from integers first.
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "checked/oplus/oplus.hpp"

using Ring = std::vector<std::pair<long, long>>;

static Ring integers(const oplus::ValidRegion& region) {
  Ring ring;
  for (const oplus::Point& p : region.components().at(0).outer)
    ring.emplace_back(p.x.get_num().get_si(), p.y.get_num().get_si());
  return ring;
}

static oplus::ValidRegion region(const Ring& ring) {
  oplus::Region region;
  oplus::Chain& chain = region.components.emplace_back().outer;
  for (const auto& [x, y] : ring) chain.push_back({x, y});
  return oplus::ValidRegion(std::move(region));
}

template <typename Value, typename Of>
static double microseconds(const std::vector<Value>& values, Of of) {
  std::vector<oplus::ValidSet> sums(values.size() / 2);
  const std::clock_t start = std::clock();
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = minkowski_sum(of(values[2 * i]), of(values[2 * i + 1]));
  return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC /
         static_cast<double>(sums.size());
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::vector<oplus::PreparedRegion> regions;
  std::vector<Ring> rings;
  std::ifstream file(argv[1]);
  for (std::string line; std::getline(file, line);) {
    regions.emplace_back(oplus::read_wkt(line));
    rings.push_back(integers(regions.back().region()));
  }
  using Prepared = oplus::PreparedRegion;
  std::cout << microseconds(regions, [](const Prepared& r) -> const Prepared& { return r; }) << ' '
            << microseconds(rings, region) << '\n';
}
