// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "checked/engine.hpp"
#include "properties/runner/child_process.hpp"

namespace oplus {

/// What `oplus-certified`, a program beside this one, says of a set and of a certificate's text; `claim` is what the
/// set should be: "sum", "open-sum", "nfp" or "ifp". Throws std::system_error where it cannot be asked.
EndedProcess checked_certificate(const std::string& claim, const Region& p, const Region& q,
                                 const ClaimedSum& set, const std::string& certificate,
                                 const ProcessLimits& limits);

/// Whether it accepts.
bool says_certified(const EndedProcess& ended);

/// slide's sums, closed and open, each with a certificate (docs/certificates.md) that `oplus-certified` must
/// accept. Its compute() throws EngineFailure: as a crash where no certificate is found or it is not accepted; and as
/// program_engine() does.
Engine certified_engine(ProcessLimits limits);

/// Whether `oplus-certified` was built; it needs Coq, OCaml and Zarith.
bool can_certify();

}  // namespace oplus
