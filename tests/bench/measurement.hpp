// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace oplus {

/// What became of an engine on a row.
enum class Outcome {
  done,
  over_limit,  ///< it was ended after `limit` seconds
  crashed,     ///< by the signal that `note` names
  failed,      ///< it threw, or left without a result: see `note`
  not_taken    ///< the engine does not take such input: see `note`
};

/// One engine on one row. Of a row of many pairs all numbers are totals.
struct Measurement {
  std::string engine;
  Outcome outcome = Outcome::done;
  std::string note;

  /// Medians. The second one is with the coordinates of the result evaluated, where that is extra.
  double seconds = 0;
  std::optional<double> seconds_evaluated;
  std::size_t runs = 0;

  /// For how much of the runs a processor worked on them. Where other programs compete it is less than
  /// 1, and the times are too long; on two threads it is 2 at best.
  double busy = 0;

  /// Resident at most, in units of 10^6 bytes: of the process until its first run has ended, or, where
  /// it did not come that far, until it ended.
  double peak_mb = 0;

  std::size_t outer = 0;
  std::size_t holes = 0;
  std::size_t vertices = 0;
  std::string area;                     ///< exactly; to 30 decimals where that is too long
  std::string digest;                   ///< of an exact result in canonical form
  std::optional<std::size_t> segments;  ///< of the convolution that was looked at, if it is known
  std::optional<std::size_t> steps;     ///< of cycle tracing
};

/// Throws nlohmann::json::exception where the text says something else.
void to_json(nlohmann::ordered_json& json, const Measurement& measurement);
void from_json(const nlohmann::ordered_json& json, Measurement& measurement);

}  // namespace oplus
