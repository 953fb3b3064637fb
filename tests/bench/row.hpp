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

/// The subject of a row.
enum class Subject {
  sums,          ///< engines of sums
  growth,        ///< slide only, for growing convolutions
  commands,      ///< whole programs, from files to a file, beside slide
  certificates,  ///< the same: the sum with a certificate, and its check
  convolution,   ///< algorithms for the convolution
  hole_tests     ///< hole tests, on the questions of rca
};

/// The same input for several engines, and their measurements.
struct Row {
  std::string name = {};
  std::string group = {};  ///< rows of a group stand together
  std::string what = {};
  Subject subject = Subject::sums;
  std::size_t pairs = 1;
  std::vector<std::string> engines = {};  ///< those to measure
  std::function<std::vector<Summands>()> make =
      {};                                ///< the same each time; empty: the input is missing
  Boundary boundary = Boundary::closed;  ///< of which sums

  /// Besides those of the engines: what identifies the row, and what compares its engines.
  std::map<std::string, std::string> words = {};
  std::map<std::string, double> numbers = {};

  std::vector<Measurement> measurements = {};

  /// Returns nullptr if the engine was not measured or, for `done`, its outcome is another.
  const Measurement* of(const std::string& engine) const;
  const Measurement* done(const std::string& engine) const;

  /// A number of the row, otherwise of the first exact engine ("sum_holes"); of an engine
  /// ("rca.seconds"), also the error of its area ("clipper.area_error" and, relative to the exact area,
  /// "clipper.relative_area_error"); or a quotient of two ("rca.seconds/winding.seconds").
  std::optional<double> number(const std::string& name) const;
};

using Rows = std::vector<Row>;

Rows rows_where(Rows rows, const std::function<bool(const Row&)>& is_one);
Rows rows_for(const Rows& rows, Subject subject);

/// Whether the results of a row agree.
struct Agreement {
  /// Empty if all exact engines that are done agree; otherwise the engines that differ.
  std::string disagreement;
  /// A result of the exact engines; nullptr if none is done.
  const Measurement* exact = nullptr;
  std::size_t compared = 0;  ///< number of exact engines
};

Agreement agreement_of(const Row& row);

/// What is wrong, a line each: exact engines that disagree, and engines of oplus that crashed or failed.
/// Whatever another library does is a result; so is exceeding a limit of time or memory.
std::vector<std::string> faults_of(const Row& row);

/// A ratio of measured numbers. For an engine that was stopped it is a lower bound.
struct Ratio {
  double value;
  bool is_lower_bound;
};

/// "12.3", "> 971".
std::string ratio_text(const Ratio& ratio);

/// The engine's number ("seconds" or "peak_mb") divided by that of `base`; empty if one of them has no
/// such number. An engine that was stopped took at least `limit` seconds.
std::optional<Ratio> ratio(const Row& row, const std::string& number, const std::string& engine,
                           const std::string& base, double limit);

/// A lower bound if one of them is. Requires: at least one.
Ratio geometric_mean(const std::vector<Ratio>& ratios);

}  // namespace oplus
