// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

namespace oplus {

/// One engine on one row. Of a row of many pairs all numbers are totals.
struct Measurement {
  /// What became of the engine.
  enum class Ending {
    done,
    over_limit,     ///< it was ended after `limit` seconds
    out_of_memory,  ///< it asked for more than the limit
    crashed,        ///< by the signal that `note` names
    failed,         ///< it threw, or left without a result: see `note`
    not_taken       ///< the engine does not take such input, or the input is missing: see `note`
  };

  std::string engine = {};
  Ending outcome = Ending::done;
  std::string note = {};
  std::string digest = {};  ///< of an exact result in canonical form; empty where an engine rounds
  std::string area = {};    ///< of a sum, exactly; to 30 decimals where that is too long

  /// By name, what is not known is absent:
  ///  - `seconds`: of the result's computation; `seconds_evaluated`: with the coordinates of the
  ///    result evaluated, where that is extra; `repetitions`: how many there were, of which these and
  ///    all other times are of the one in the middle, and in it the mean of its runs;
  ///  - `busy`: for how much of the runs a processor worked on them. Where other programs compete it
  ///    is less than 1, and the times are too long; on two threads it is 2 at best;
  ///  - `peak_mb`: resident at most, in units of 10^6 bytes: of the process until its first run has
  ///    ended, or, where it did not come that far, until it ended;
  ///  - `m` and `n`: the vertices of P and Q; `sum_outer`, `sum_holes`, `sum_vertices`: of the result;
  ///  - what else an engine says of its work, such as `segments` of the convolution.
  std::map<std::string, double> numbers = {};

  bool is_done() const { return outcome == Ending::done; }
  std::optional<double> number(const std::string& name) const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
  }
};

/// What became of an engine in a few words: "done", "> 60 s", "crashed: signal 6".
std::string in_words(const Measurement& measurement);

}  // namespace oplus
