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

/// Whether an input got as far as what the target is about: was read, or decoded to two regions.
enum class FuzzOutcome { reached, rejected };

/// What a fuzzer needs to know of one thing to be fuzzed. Nothing in here knows libFuzzer; what
/// joins the two is libfuzzer/entry.cpp. Functions of the input alone: same bytes, same result.
struct FuzzTarget {
  std::string name;
  std::string what;  ///< a line for people

  /// Throws FuzzFinding, or whatever else oplus throws and should not.
  FuzzOutcome (*run)(std::string_view input);

  /// An input like this one, and one of two: most of them not rejected where these are not.
  std::string (*mutated)(Random& random, std::string_view input);
  std::string (*crossed)(Random& random, std::string_view a, std::string_view b);

  std::size_t longest;  ///< input in bytes; longer ones are slow and show nothing new
};

/// Each in a file of its own, so that a program has to contain only the one it runs.
const FuzzTarget& dat_target();
const FuzzTarget& wkt_target();
const FuzzTarget& geojson_target();
const FuzzTarget& sums_target();
const FuzzTarget& slide_target();

}  // namespace oplus
