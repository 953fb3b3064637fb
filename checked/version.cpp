// SPDX-License-Identifier: MIT
#include "checked/version.hpp"

namespace oplus {

const char* const version = OPLUS_VERSION;

}  // namespace oplus
