// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/families/family.hpp"

namespace oplus {

/// A published pair, in files of the folder `data/`.
struct PublishedPair {
  std::string name;

  /// Its row in the thesis's Table 6.1: times in seconds, edges of the arrangements.
  struct Measured {
    double t_w;
    double t_rc;
    double a_w;
    double a_rc;
  };
  std::optional<Measured> in_thesis = {};

  std::string what = "";            ///< description; empty if the benchmark has no row of it
  std::string p = name + "_part1";  ///< its file, without .dat
  std::string q = name + "_part2";

  bool is_there() const;

  /// Throws InvalidInput.
  Summands read() const;
};

/// All published pairs, those of Table 6.1 first, in its order.
const std::vector<PublishedPair>& published_pairs();

}  // namespace oplus
