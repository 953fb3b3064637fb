// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/engine.hpp"
#include "properties/runner/child_process.hpp"

namespace oplus {

/// slide's closed sum, each with a certificate (docs/certificates.md) that `oplus-certified`, a program beside
/// this one, must accept. Its compute() throws NoSum: for open sums, which have no certificates; as a crash where
/// none is found or it is not accepted; and as program_engine() does.
Engine certified_engine(ProcessLimits limits);

/// Whether `oplus-certified` was built; it needs Coq, OCaml and Zarith.
bool can_certify();

}  // namespace oplus
