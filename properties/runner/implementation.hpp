// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checked/arrangement/hole_test.hpp"
#include "properties/runner/compared_hole_tests.hpp"
#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// Anything that maps two regions to a sum, so that it can be held against the oracle. Adds what it
/// asked of hole tests to `probes`.
struct Implementation {
  std::string name;
  std::function<MinkowskiSum(const Region& p, const Region& q, Boundary boundary, Probes& probes)>
      sum;
};

/// One that asks no hole test.
Implementation without_probes(
    std::string name,
    std::function<MinkowskiSum(const Region& p, const Region& q, Boundary boundary)> sum);

/// The engines of oplus, the default first, with a hole test; without one, each asks all hole tests
/// at every probe (compared_hole_tests.hpp), and so runs as with each of them.
const std::vector<Implementation>& implementations(
    std::optional<HoleTestMethod> hole_test = std::nullopt);

}  // namespace oplus
