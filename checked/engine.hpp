// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "checked/statistics.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// A sum and what it took to compute it.
struct ComputedSum {
  PlanarSet sum;
  Origins origins;  ///< empty unless asked for
  Statistics statistics;
};

class HoleTest;  // checked/arrangement/hole_test.hpp

/// Prepares a hole test for two regions. Requires: p and q are valid (validity.hpp).
using HoleTestMethod = std::function<std::unique_ptr<HoleTest>(const Region& p, const Region& q)>;

/// The numbers that slide computes with. Larger ones than are needed are slower, and change nothing.
enum class SlideNumbers { as_needed, at_least_128_bits, gmp, rationals };

/// Says how an engine is to compute. No sum depends on it, and an engine ignores what it has no use for.
struct EngineOptions {
  bool with_origins = false;      ///< whether the result says where each edge came from
  unsigned threads = 1;           ///< at least 1
  HoleTestMethod hole_test = {};  ///< DEFAULT: by hierarchies of bounding volumes
  SlideNumbers numbers = SlideNumbers::as_needed;

  /// Called while slide searches, now and then and on any of its threads: how many segments are done.
  /// DEFAULT: nobody is told.
  std::function<void(std::size_t done, std::size_t total)> progress = {};
};

/// Anything that maps two regions to their sum: an algorithm of ours, the oracle, another
/// library or program.
struct Engine {
  std::string name;
  std::string what = {};       ///< a line for a list
  bool has_hole_test = false;  ///< whether the choice of a hole test makes a difference
  bool has_threads = false;    ///< whether the number of threads does

  /// Requires: p and q are valid (validity.hpp).
  std::function<ComputedSum(const Region& p, const Region& q, Boundary boundary,
                            const EngineOptions& options)>
      compute = {};
};

/// Returns their names, in the same order.
inline std::vector<std::string> names_of(const std::vector<Engine>& engines) {
  std::vector<std::string> names;
  for (const Engine& engine : engines) names.push_back(engine.name);
  return names;
}

/// Returns nullptr for an unknown name.
inline const Engine* find_engine(const std::vector<Engine>& engines, std::string_view name) {
  const auto found = std::find_if(engines.begin(), engines.end(),
                                  [&](const Engine& engine) { return engine.name == name; });
  return found == engines.end() ? nullptr : &*found;
}

}  // namespace oplus
