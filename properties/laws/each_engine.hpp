// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "properties/runner/statement.hpp"
#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// P ⊕ Q by one engine, closed or open.
using Sum = std::function<MinkowskiSum(const Region& p, const Region& q)>;

/// Closed and open, in this order.
struct BothSums {
  Sum closed;
  Sum open;
};

/// A law on sums: returns what is wrong, nothing where it holds.
using Law = std::function<std::string(const Sum& sum)>;

/// Tries a law on every engine, closed and open; the outcome names the first that breaks it.
Outcome of_each_engine(const Law& law);

/// The same for laws that speak of closed and open sums at once.
Outcome of_each_engine(const std::function<std::string(const BothSums& sums)>& law);

/// How two sums differ, in words; empty where they are equal.
std::string told_apart(const MinkowskiSum& first, const MinkowskiSum& second);

}  // namespace oplus
