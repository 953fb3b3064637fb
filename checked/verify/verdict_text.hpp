// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "checked/verify/verdict.hpp"

namespace oplus {

/// "yes", or "no" with the first reason, its witness, and the other kinds of reasons; lines.
std::string text_of(const Verdict& verdict);

}  // namespace oplus
