// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "checked/arrangement/hole_test.hpp"
#include "checked/cli/statistics.hpp"
#include "checked/computed_sum.hpp"
#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

struct Computed {
  MinkowskiSum sum;
  Origins origins;  ///< empty unless asked for
  Statistics statistics;
};

struct EngineOptions {
  WithOrigins with_origins = WithOrigins::no;
  HoleTestMethod hole_test = HoleTestMethod::hierarchy;
  unsigned threads = 1;
};

/// A way to compute a sum that the program offers.
struct Engine {
  std::string name;
  std::string what;    ///< a line for the help
  bool has_hole_test;  ///< whether the choice of a hole test makes a difference
  bool has_threads;    ///< whether the number of threads does
  Computed (*compute)(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options);
};

/// All engines, the default first.
const std::vector<Engine>& engines();

/// Returns nullptr for an unknown name.
const Engine* find_engine(const std::string& name);

}  // namespace oplus
