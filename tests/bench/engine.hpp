// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "properties/compare/peers/method.hpp"
#include "tests/bench/measurement.hpp"

namespace oplus {

/// Pairs in an engine's own form, ready to be computed again and again.
class PreparedPairs {
 public:
  virtual ~PreparedPairs() = default;

  /// What is measured: computes the result of each pair in the engine's own form and keeps it.
  /// Requires: nothing is kept.
  virtual void compute() = 0;

  /// Forgets what compute() kept.
  virtual void forget() = 0;

  /// Whether compute() leaves coordinates unevaluated, which evaluate() makes up for.
  virtual bool is_lazy() const { return false; }
  virtual void evaluate() {}

  /// Says what compute() kept.
  virtual void describe(Measurement& measurement) const = 0;
};

struct BenchmarkedEngine {
  std::string name;
  std::string what;
  Arithmetic arithmetic;
  bool is_ours;

  /// Throws NotTaken.
  std::unique_ptr<PreparedPairs> (*prepare)(const std::vector<Summands>& pairs);
};

/// All engines, in the order in which they are listed; with those that are at fault on purpose, by
/// which the benchmark itself is tested, at the end.
const std::vector<BenchmarkedEngine>& benchmarked_engines();
inline constexpr std::size_t engines_at_fault = 3;

/// Returns nullptr for an unknown name.
const BenchmarkedEngine* find_benchmarked_engine(const std::string& name);

using Prepare = std::unique_ptr<PreparedPairs>(const std::vector<Summands>& pairs);

Prepare prepare_slide;
Prepare prepare_slide_on_two_threads;
Prepare prepare_rca;
Prepare prepare_winding;
Prepare prepare_cgal_reduced;
Prepare prepare_cgal_full;
Prepare prepare_cgal_vertical;
Prepare prepare_clipper;
Prepare prepare_boost_polygon;

/// The convolution itself, not a sum: by cycle tracing, and by all pairs.
Prepare prepare_traced_convolution;
Prepare prepare_naive_convolution;

/// At fault on purpose: aborts, never ends, returns a sum with one vertex moved.
Prepare prepare_crash;
Prepare prepare_hang;
Prepare prepare_wrong;

}  // namespace oplus
