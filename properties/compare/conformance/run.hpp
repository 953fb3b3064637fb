// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "properties/compare/conformance/report.hpp"

namespace oplus {

/// Tries the shard's part of a plan on an implementation, so many pairs at a time, and shrinks the
/// smallest pair of each kind of failure. `done` is called after each trial, never by two threads at
/// once. Same settings, same plan and an implementation that answers the same: same report.
ConformanceReport run_conformance(
    const Engine& implementation, const ConformanceSettings& settings, const ConformancePlan& plan,
    unsigned threads, const std::function<void()>& done = [] {});

}  // namespace oplus
