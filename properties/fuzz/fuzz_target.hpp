// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "reference/families/random.hpp"

namespace oplus {

/// What a target exists to find: an input on which oplus is wrong. what() says in a line how.
class FuzzFinding : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws FuzzFinding unless that holds.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw FuzzFinding(what);
}

/// Whether an input got as far as what the target is about: was read, or decoded to two regions.
enum class FuzzOutcome { reached, rejected };

/// What a fuzzer needs to know of one thing to be fuzzed. Nothing in here knows libFuzzer; what
/// joins the two is main.cpp. Functions of the input alone: same bytes, same result.
struct FuzzTarget {
  const char* name;
  const char* what;  ///< a line for people

  /// Throws FuzzFinding, or whatever else oplus throws and should not.
  FuzzOutcome (*run)(std::string_view input);

  /// An input like this one: mostly not rejected where this is not.
  std::string (*mutated)(Random& random, std::string_view input);
  /// The same of two; libFuzzer's own crossing over where there is none.
  std::string (*crossed)(Random& random, std::string_view a, std::string_view b) = nullptr;

  int bytes_one_in = 2;        ///< so often libFuzzer's own mutations take the place of `mutated`
  std::size_t longest = 2048;  ///< input in bytes; longer ones are slow and show nothing new
};

/// In files of their own, so that a program for texts need not contain slide.
extern const FuzzTarget dat_target, wkt_target, geojson_target, sums_target, slide_target;

}  // namespace oplus
