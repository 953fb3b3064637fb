// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/io/invalid_input.hpp"

namespace oplus {

/// The whole message with which `read` refuses, or "accepted".
template <typename Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  return "accepted";
}

}  // namespace oplus
