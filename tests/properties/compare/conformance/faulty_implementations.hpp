// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "checked/slide/slide.hpp"
#include "properties/compare/conformance/run.hpp"
#include "properties/runner/checked_engines.hpp"

namespace oplus {

/// slide, its sum changed.
inline Engine changed(const std::function<void(MinkowskiSum& sum)>& change) {
  return named_engine("changed", [change](const Region& p, const Region& q, Boundary boundary) {
    MinkowskiSum sum = slide_sum(p, q, boundary).sum;
    change(sum);
    return sum;
  });
}

/// slide, but for pairs of which something holds.
inline Engine failing(const std::function<bool(const Summands&)>& fails,
                      const std::function<MinkowskiSum()>& failure) {
  return named_engine("failing", [=](const Region& p, const Region& q, Boundary boundary) {
    if (fails({p, q})) return failure();
    return slide_sum(p, q, boundary).sum;
  });
}

/// Few pairs of parts that need nothing but the oracle: grids, whose pairs are small and have no holes,
/// and families.
inline ConformanceSettings few(const std::vector<std::string>& parts = {"grids", "families"}) {
  ConformanceSettings settings;
  settings.cases = 4;
  settings.shrink_tries = 150;
  settings.parts = parts;
  return settings;
}

inline ConformanceReport conformance_of(const Engine& implementation,
                                        const ConformanceSettings& settings = few()) {
  return run_conformance(implementation, settings, conformance_plan(settings), 2);
}

}  // namespace oplus
