// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "reference/families/random.hpp"

namespace oplus {

/// An input on which oplus is wrong. what() says in a line how.
class FuzzFinding : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws FuzzFinding unless that holds.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw FuzzFinding(what);
}

/// Whether an input was valid for the target: was read, or decoded to two regions.
enum class FuzzOutcome { reached, rejected };

/// Something to be fuzzed. It does not depend on libFuzzer; main.cpp connects the two. The result of each
/// function depends on its arguments only.
struct FuzzTarget {
  const char* name;
  const char* what;  ///< a line for people

  /// Throws FuzzFinding, or an exception that oplus should not throw.
  FuzzOutcome (*run)(std::string_view input);

  /// A similar input: mostly not rejected if this one is not. Every other mutation is libFuzzer's own, or
  /// all where this is null.
  std::string (*mutated)(Random& random, std::string_view input);

  std::size_t longest = 2048;  ///< input in bytes; longer ones are slow and show nothing new
};

/// In separate files, so that a program for texts need not contain slide.
extern const FuzzTarget dat_target, wkt_target, geojson_target, sums_target, layouts_target,
    slide_target;

}  // namespace oplus
