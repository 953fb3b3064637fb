// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "checked/engine.hpp"
#include "properties/runner/statement.hpp"

namespace oplus {

/// P ⊕ Q by one engine, for laws that are asked of closed sums or of open ones.
class Sum {
 public:
  Sum(const Engine& by, Boundary boundary) : by_(by), boundary_(boundary) {}

  /// The one asked about.
  PlanarSet operator()(const Region& p, const Region& q) const { return sum(p, q, boundary_); }
  /// The closed one, always: a region again.
  PlanarSet closed(const Region& p, const Region& q) const { return sum(p, q, Boundary::closed); }
  bool is_open() const { return boundary_ == Boundary::open; }

 private:
  PlanarSet sum(const Region& p, const Region& q, Boundary boundary) const {
    return by_.compute(p, q, boundary, {}).sum;
  }

  const Engine& by_;
  Boundary boundary_;
};

/// The outcome of a law on sums for a pair.
using Law = std::function<Outcome(const Sum& sum, const Summands& summands)>;

/// Holds unless `broken` says otherwise.
Outcome unless_broken(std::string what);

/// Fits `Statement::check`: asks the law of every engine, closed and open; the outcome names the first
/// that breaks it, and counts what was looked at once. An engine that throws breaks it.
std::function<Outcome(const Summands&)> of_each_engine(Law law);

/// Fits `Statement::of_engine`.
std::function<Outcome(const Engine&, Boundary, const Summands&)> for_one_engine(Law law);

/// How two sums differ, in words; empty where they are equal.
std::string difference_in_words(const PlanarSet& first, const PlanarSet& second);

}  // namespace oplus
