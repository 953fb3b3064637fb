// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <vector>

#include "checked/engine.hpp"
#include "reference/families/family.hpp"

namespace oplus {

// A method is another library's function for Minkowski sums. It has
//   using Part = …;   a region in its own form
//   using Input = …;  a pair in its own form
//   using Sum = …;    a sum in its own form
//   static constexpr bool rounds = …;  its sums may be inexact
//   Input converted(const Summands& pair) const;  throws Unsupported
//   static IntegerScale scale_of(const std::vector<Region>& regions);  that suits it; throws Unsupported
//   Part part(const Region& region, const IntegerScale& scale) const;  throws Unsupported
//   Input paired(const Part& p, const Part& q) const;  in the parts' units; throws Unsupported
//   Sum sum(const Input& input) const;
//   ReturnedChains chains(const Input& input, const Sum& sum) const;
//   and, if it leaves coordinates unevaluated, static void evaluate(const Sum& sum);
//   and, if it knows, static std::size_t segments(const Sum& sum);

/// The library does not support the pair, such as polygons with holes.
class Unsupported : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The regularized boundary that a method returned: the sum is to the left of each chain.
using ReturnedChains = std::vector<Chain>;

}  // namespace oplus
