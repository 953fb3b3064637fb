// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

namespace oplus {

/// One engine on one row. For a row of many pairs all numbers are totals.
struct Measurement {
  /// The outcome.
  enum class Ending {
    done,
    over_limit,     ///< stopped after `limit` seconds
    out_of_memory,  ///< requested more than the limit
    crashed,        ///< by the signal in `note`
    failed,         ///< threw, or returned no result: see `note`
    unsupported     ///< the engine does not support the input, or it is missing: see `note`
  };

  std::string engine = {};
  Ending outcome = Ending::done;
  std::string note = {};
  std::string digest = {};  ///< of an exact result in canonical form; empty if the engine rounds
  std::string area = {};    ///< of a sum, exactly; with 30 decimals if that is too long

  /// By name; unknown ones are absent:
  ///  - `seconds`: to compute the result; `seconds_evaluated`: with its coordinates evaluated, if the
  ///    engine is lazy; `repetitions`: their number. All times are of the median repetition, in which
  ///    they are the mean of its runs;
  ///  - `busy`: processor time divided by `seconds`. It is less than 1 if other programs compete, and
  ///    then the times are too long; with two threads it is at most 2;
  ///  - `peak_mb`: peak resident memory in units of 10^6 bytes, of the process until its first run has
  ///    ended, or until it ended itself;
  ///  - `m` and `n`: the vertices of P and Q; `sum_chains`, `sum_holes`, `sum_vertices`: of the result;
  ///  - other numbers of the engine, such as `segments` of the convolution.
  std::map<std::string, double> numbers = {};

  bool is_done() const { return outcome == Ending::done; }
  std::optional<double> number(const std::string& name) const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
  }
};

/// The outcome in a few words: "done", "> 60 s", "crashed: signal 6".
std::string in_words(const Measurement& measurement);

}  // namespace oplus
