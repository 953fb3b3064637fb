// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "checked/cli/command_line/description.hpp"

namespace oplus {

// Manual pages of section 1, for the man macros of groff and mandoc. A footer's sections, a line
// that ends in a colon and lines that are indented, become sections; its examples stay as they are.

std::string man_page(const DescribedProgram& program);
std::string man_page(const DescribedProgram& program, const DescribedCommand& command);

}  // namespace oplus
