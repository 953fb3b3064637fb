// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "checked/rounding/rounding.hpp"
#include "properties/compare/failure_kind.hpp"

namespace oplus {

/// The first promise of rounding (rounding.hpp) that a result breaks, with a point that shows it; nullopt where
/// it keeps all. Kinds: "off the grid", a vertex; "side not kept"; "beyond the bound", in x or in y. Sets are located
/// at a point of every cell of both boundaries, distances are compared there where the sets differ and on the new
/// boundary; no code of rounding is used. Requires: the set is closed, without edges and points of its own.
std::optional<Failure> broken_promise(const PlanarSet& set, const RoundedSet& result,
                                      const Rational& step, Side side);

}  // namespace oplus
