// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "reference/definitions/values.hpp"

namespace oplus {

/// How the sum of two bounded valid regions is computed: by slide, or any other engine.
using SumOf = std::function<PlanarSet(const Region& p, const Region& q, Boundary boundary)>;

}  // namespace oplus
