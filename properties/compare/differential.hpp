// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checked/engine.hpp"
#include "properties/compare/no_sum.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/families/family.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

/// How a pair is to be made: lazily, so that a run of thousands holds few at a time.
struct DifferentialCase {
  std::string name;   ///< says how to make it again
  std::string group;  ///< a family, or "files"
  std::function<Summands()> make;
};

/// How often hole tests were asked.
struct Probes {
  std::size_t faces = 0;
  std::size_t points = 0;

  /// Those of a run; engines without hole tests have none.
  Probes& operator+=(const Statistics& run);
  Probes& operator+=(const Probes& more);
};

/// An implementation and the oracle do not agree on a pair.
struct Disagreement {
  std::string implementation;
  Boundary boundary;
  MinkowskiSum by_oracle;
  std::optional<MinkowskiSum> by_implementation;  ///< none where it threw
  std::optional<NoSum> no_sum;                    ///< where it threw that
  std::string what;                               ///< a line that says how they differ
  std::optional<Point> witness;                   ///< a point at which they do
};

/// An implementation does not take a pair, which is neither agreement nor disagreement.
struct NotTakenSum {
  std::string implementation;
  Boundary boundary;
  std::string why;
};

/// What one case showed. An exception of an implementation is a disagreement; one of the oracle is
/// too, since it decides nothing then.
struct DifferentialResult {
  enum class Kind { agreed, disagreed, skipped };
  Kind kind = Kind::agreed;
  std::string why;                     ///< for skipped
  std::vector<NotTakenSum> not_taken;  ///< where all are, the case is skipped
  std::optional<Disagreement> disagreement;
  Probes probes;                        ///< of all implementations
  std::optional<OracleSums> by_oracle;  ///< none for skipped, or where the oracle threw

  bool holes_in_sum = false;
  bool holes_in_summand = false;
  bool low_dimensional_features = false;  ///< of the open sum
  bool overlapping_segments = false;      ///< of the reduced convolution
  bool several_components = false;        ///< of a summand
};

/// Compares closed and open sums. Pairs whose convolution has more segments than `largest` are
/// skipped: the oracle's cost grows with the square of that number.
DifferentialResult differential(const Summands& summands,
                                const std::vector<Engine>& implementations, std::size_t largest);

/// Returns a pair on which the same implementation still disagrees, for the same boundary and in the
/// same way (wrong stays wrong, a crash the same crash), and no smaller one does (see shrinking.hpp);
/// and the disagreement on it. After `most_tries` pairs were tried it returns the smallest so far: a
/// try may cost a process, or all of its time limit.
struct ShrunkDisagreement {
  Summands summands;
  Disagreement disagreement;
};
ShrunkDisagreement shrink(const Summands& summands, const Disagreement& disagreement,
                          const std::vector<Engine>& implementations,
                          std::size_t most_tries = static_cast<std::size_t>(-1));

/// Runs all cases on so many threads. `done` is called once a case, in any order, never by two
/// threads at once.
void run_differential(
    const std::vector<DifferentialCase>& cases, const std::vector<Engine>& implementations,
    std::size_t largest, unsigned threads,
    const std::function<void(std::size_t index, const DifferentialResult& result)>& done);

}  // namespace oplus
