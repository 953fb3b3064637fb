// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"
#include "reference/families/family.hpp"
#include "tests/bench/measurement.hpp"

namespace oplus {

/// What a row is for.
enum class Subject {
  sums,         ///< engines of sums
  growth,       ///< slide alone, as the convolution grows
  convolution,  ///< ways to the convolution
  hole_tests    ///< ways to answer what rca asks
};

/// The same input for several engines, and what was measured of them.
struct Row {
  std::string name = {};
  std::string group = {};  ///< rows of one group are neighbours
  std::string what = {};
  Subject subject = Subject::sums;
  std::size_t pairs = 1;
  std::vector<std::string> engines = {};  ///< that are for it
  std::function<std::vector<Summands>()> make =
      {};                                ///< the same each time; empty: the input is missing
  Boundary boundary = Boundary::closed;  ///< of which sums

  /// Besides the engines' own: what tells the row from others, and what compares its engines.
  std::map<std::string, std::string> words = {};
  std::map<std::string, double> numbers = {};

  std::vector<Measurement> measurements = {};

  /// Returns nullptr where the engine was not asked, or, for `done`, did not get to the end.
  const Measurement* of(const std::string& engine) const;
  const Measurement* done(const std::string& engine) const;

  /// A number: the row's own, else that of the first exact engine ("sum_holes"); an engine's
  /// ("rca.seconds"), also how far its area is off ("clipper.area_error" and, as a part of the exact
  /// one, "clipper.relative_area_error"); or a quotient of two ("rca.seconds/winding.seconds").
  std::optional<double> number(const std::string& name) const;
};

using Rows = std::vector<Row>;

Rows rows_where(Rows rows, const std::function<bool(const Row&)>& is_one);
Rows rows_for(const Rows& rows, Subject subject);

/// What results say about each other.
struct Agreement {
  /// Empty if all exact engines that got to the end agree; else who differs from whom.
  std::string disagreement;
  /// What the exact engines found; nullptr if none got to the end.
  const Measurement* exact = nullptr;
  std::size_t compared = 0;  ///< exact engines
};

Agreement agreement_of(const Row& row);

/// What is wrong, a line each: exact engines that disagree, and engines of ours that crashed or failed.
/// What a peer does is a result; so is a limit of time or memory that is passed.
std::vector<std::string> faults_of(const Row& row);

/// A ratio of what was measured. Of an engine that was ended it is a lower bound.
struct Ratio {
  double value;
  bool is_lower_bound;
};

/// "12.3", "> 971".
std::string ratio_text(const Ratio& ratio);

/// How many times as long as `base` an engine takes ("seconds"), or as much memory ("peak_mb"); none
/// where one of them has no such number. An engine that was ended took at least `limit` seconds.
std::optional<Ratio> ratio(const Row& row, const std::string& number, const std::string& engine,
                           const std::string& base, double limit);

/// A lower bound as soon as one of them is. Requires: at least one.
Ratio geometric_mean(const std::vector<Ratio>& ratios);

}  // namespace oplus
