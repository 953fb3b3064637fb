// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/row.hpp"

namespace oplus {

/// A row's pairs in an engine's own form, ready to be computed again and again.
class PreparedPairs {
 public:
  virtual ~PreparedPairs() = default;

  /// What is measured: computes the result of each pair in the engine's own form and keeps it.
  /// Requires: nothing is kept.
  virtual void compute() = 0;

  /// Forgets what compute() kept.
  virtual void forget() = 0;

  /// Evaluates coordinates that compute() left unevaluated; returns false where there are none.
  virtual bool evaluate() { return false; }

  /// Adds how long the stages of the last compute() took, by name.
  virtual void add_stages(std::map<std::string, double>& seconds) const {
    static_cast<void>(seconds);
  }

  /// Says what compute() kept. The measurement has its times already.
  virtual void describe(Measurement& measurement) const = 0;
};

/// What can be measured on rows of one subject.
struct BenchEngine {
  std::string name;
  std::string what;
  Subject subject;
  bool rounds;
  bool is_ours;

  /// Throws NotTaken.
  std::function<std::unique_ptr<PreparedPairs>(const Row& row, const std::vector<Summands>& pairs)>
      prepare;
  bool is_at_fault = false;  ///< on purpose
};

/// All engines, in the order in which they are listed.
const std::vector<BenchEngine>& bench_engines();

/// Returns nullptr for an unknown name. Rows of growth are for engines of sums.
const BenchEngine* find_bench_engine(Subject subject, const std::string& name);

// What the list is made of.

/// Engines of sums: of oplus, also slide on two threads, and of others.
std::vector<BenchEngine> own_engines();
std::vector<BenchEngine> peer_engines();

/// The convolution itself, not a sum: by cycle tracing, the same but which segments there are and not
/// where, and by all pairs (thesis, Section 3.2.1).
std::vector<BenchEngine> convolution_engines();

/// Each prepares a hole test and asks it questions about the row's pair: rca's or, as the row's word
/// `about` says, one about each edge of the arrangement.
std::vector<BenchEngine> hole_test_engines();

/// By which the benchmark itself is tested: one crashes, one never ends, one moves a vertex of the sum.
std::vector<BenchEngine> engines_at_fault();

}  // namespace oplus
