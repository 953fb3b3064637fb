// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/each_engine.hpp"

#include <exception>
#include <utility>

#include "properties/runner/checked_engines.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// An engine that throws is named, too.
Outcome asked(const Law& law, const Engine& engine, Boundary boundary, const Summands& summands) {
  try {
    return law(Sum(engine, boundary), summands);
  } catch (const std::exception& e) {
    return unless_broken(std::string("it threw: ") + e.what());
  }
}

}  // namespace

Outcome unless_broken(std::string what) {
  Outcome outcome;
  return what.empty() ? outcome : outcome.fail(std::move(what));
}

std::function<Outcome(const Summands&)> of_each_engine(Law law) {
  return [law = std::move(law)](const Summands& summands) {
    Outcome outcome;
    for (const Engine& engine : checked_engines()) {
      for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
        outcome = asked(law, engine, boundary, summands);
        if (outcome.kind == Outcome::Kind::holds) continue;
        if (outcome.kind == Outcome::Kind::fails)
          outcome.why.insert(0, engine.name + ", " + name(boundary) + ": ");
        return outcome;
      }
    }
    return outcome;
  };
}

std::function<Outcome(const Engine&, Boundary, const Summands&)> for_one_engine(Law law) {
  return [law = std::move(law)](const Engine& engine, Boundary boundary, const Summands& summands) {
    return law(Sum(engine, boundary), summands);
  };
}

std::string difference_in_words(const PlanarSet& first, const PlanarSet& second) {
  const auto found = difference(first, second);
  return found ? found->what + ", at " + to_string(found->witness) : "";
}

}  // namespace oplus
