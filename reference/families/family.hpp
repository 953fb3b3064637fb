// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "reference/definitions/region.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// The two regions that are summed.
struct Summands {
  Region p;
  Region q;

  friend bool operator==(const Summands&, const Summands&) = default;
};

/// A family of pairs. `make` returns valid regions; n is their size as the family understands it.
struct Family {
  std::string name;
  std::string what;  ///< one line, says what n is
  Summands (*make)(Random& random, std::size_t n);
  std::size_t smallest;          ///< the least n the family takes
  std::size_t typical;           ///< the n that differential runs use at most
  std::size_t largest = 10'000;  ///< no machine integer overflows up to this n
};

/// All families, in the order in which they are listed.
const std::vector<Family>& families();

/// Returns nullptr for an unknown name.
const Family* find_family(const std::string& name);

/// Same family, n and seed: same pair, on every compiler.
/// Throws std::invalid_argument, its message fit for a user, where n < family.smallest.
Summands generate(const Family& family, std::size_t n, std::uint64_t seed);

}  // namespace oplus
