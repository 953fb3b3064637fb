// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/planar_set.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

/// A named pair with its sums. What is written where: tests/corpus/pairs.txt.
template <typename Summand>
struct CorpusRow {
  std::string name;
  std::string story;
  Summand p;
  Summand q;
  PlanarSet closed;
  PlanarSet open;
};

using CorpusPair = CorpusRow<Region>;
using CorpusSets = CorpusRow<ReadSet>;

/// Returns the pairs of regions in the order of the file. Throws InvalidInput or std::runtime_error, naming
/// the row, where one is wrong.
std::vector<CorpusPair> corpus();

/// The other pairs likewise: in each of them P or Q has a line string or a point.
std::vector<CorpusSets> corpus_of_sets();

}  // namespace oplus
