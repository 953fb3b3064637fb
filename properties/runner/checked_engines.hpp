// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "checked/engine.hpp"

namespace oplus {

/// All hole tests as one (compared_hole_tests.hpp): an engine that asks them runs as with each.
HoleTestMethod all_hole_tests();

/// The engines of oplus (checked/engines/engines.hpp), each with this hole test whatever its options say.
std::vector<Engine> checked_engines(const HoleTestMethod& hole_test = all_hole_tests());

/// An engine that is a function.
Engine named_engine(
    std::string name,
    std::function<PlanarSet(const Region& p, const Region& q, Boundary boundary)> sum);

}  // namespace oplus
