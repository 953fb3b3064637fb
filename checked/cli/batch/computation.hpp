// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "checked/cli/batch/results.hpp"
#include "checked/cli/output.hpp"
#include "checked/operations/operations.hpp"
#include "checked/slide/prepared_summand.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

/// How a result is written: as a geometry, or its area alone.
enum class ResultForm { wkt, geojson, wkb, area };

/// What is computed of each pair, and how it is written.
struct Computation {
  const Operation& operation;
  ResultForm form = ResultForm::wkt;
  std::optional<OutputGrid> grid = {};  ///< of results; they are exact if empty
  std::optional<int> digits = {};       ///< of areas; they are exact if empty
  std::optional<Region> disc = {};      ///< of Q's spacing (shared_options.hpp)

  /// Q, grown by the disc if there is one.
  ReadSet spaced_q(ReadSet q) const;

  /// Adds the result of a pair, the second one spaced_q(Q), to a line. Throws UsageError where P must be a region, and is not.
  void add(std::string& line, const ReadSet& p, const ReadSet& q) const;

  /// Whether it is one sum, of P and of second_summand(Q): then both may be prepared, if they are regions.
  bool is_sum_of_prepared() const;
  Region second_summand(Region q) const;
  void add(std::string& line, const slide::PreparedSummand& p,
           const slide::PreparedSummand& q) const;

 private:
  void add(std::string& line, PlanarSet result) const;
};

/// Adds a line to the results. compute(line) gets the beginning of the line, `{"line": 7` for example, and
/// completes it but for the brace. What it throws becomes an "error" behind that beginning.
void add_line(Results& results, const std::string& beginning,
              const std::function<void(std::string& line)>& compute);

/// Adds a line that is an error.
void add_error(Results& results, const std::string& beginning, const std::string& what);

/// Counts an error, but no line.
void count_error(Results& results, const std::string& what);

/// The error of a pair for which there is not enough memory.
inline constexpr const char* without_memory = "there is not enough memory for this input";

/// A string as JSON.
std::string in_json(const std::string& text);

}  // namespace oplus
