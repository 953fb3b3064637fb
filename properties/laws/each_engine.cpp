// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/laws/each_engine.hpp"

#include <exception>

#include "properties/runner/implementation.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Sum sum_by(const Implementation& engine, Boundary boundary) {
  return [&engine, boundary](const Region& p, const Region& q) {
    Probes probes;
    return engine.sum(p, q, boundary, probes);
  };
}

/// An engine that throws is named, too.
std::string wrong(const std::function<std::string()>& law) {
  try {
    return law();
  } catch (const std::exception& e) {
    return std::string("it threw: ") + e.what();
  }
}

}  // namespace

Outcome of_each_engine(const Law& law) {
  Outcome outcome;
  for (const Implementation& engine : implementations()) {
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      const std::string what = wrong([&] { return law(sum_by(engine, boundary)); });
      if (what.empty()) continue;
      outcome.kind = Outcome::Kind::fails;
      outcome.why = engine.name + (boundary == Boundary::closed ? ", closed: " : ", open: ") + what;
      return outcome;
    }
  }
  return outcome;
}

Outcome of_each_engine(const std::function<std::string(const BothSums& sums)>& law) {
  Outcome outcome;
  for (const Implementation& engine : implementations()) {
    const BothSums sums{sum_by(engine, Boundary::closed), sum_by(engine, Boundary::open)};
    const std::string what = wrong([&] { return law(sums); });
    if (what.empty()) continue;
    outcome.kind = Outcome::Kind::fails;
    outcome.why = engine.name + ": " + what;
    return outcome;
  }
  return outcome;
}

std::string told_apart(const MinkowskiSum& first, const MinkowskiSum& second) {
  const auto found = difference(first, second);
  return found ? found->what + ", at " + to_string(found->witness) : "";
}

}  // namespace oplus
