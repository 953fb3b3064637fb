// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "reference/definitions/planar_set.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// The same input for several engines.
struct Row {
  std::string name = {};
  std::string group = {};  ///< rows of a group stand together
  std::string what = {};
  std::string subject = "sums";  ///< the section of the page, or the experiment
  std::size_t pairs = 1;
  std::string kind = "sums";                         ///< of the engines
  std::vector<std::string> engines = {};             ///< those to measure
  std::function<std::vector<Summands>()> make = {};  ///< the same each time
  Boundary boundary = Boundary::closed;              ///< of which sums
  std::string parts = {};                            ///< the file, where all are pairs of it
  bool about_edges = false;                          ///< the questions of hole tests
};

using Rows = std::vector<Row>;

/// The rows of docs/benchmarks.md.
Rows benchmark_rows();

/// Those of chapter 6 of the thesis: the same seed gives the same pairs; `scale` multiplies the largest size
/// of each family, of which the smallest is always there.
Rows experiment_rows(std::uint64_t seed, double scale);

/// A pair of published polygons, in files NAME.dat of tests/data.
std::vector<Summands> published_pair(const std::string& p, const std::string& q);

}  // namespace oplus
