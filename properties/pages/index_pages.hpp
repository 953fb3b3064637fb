// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/pages/theorem_page.hpp"

namespace oplus {

/// docs/theorems.md: all statements, chapter by chapter, and how they rest on each other.
Page theorems_page(const Registry& registry);

/// docs/mutants.md: which statements kill which mutant, after how many cases.
Page mutants_page(const Registry& registry);

}  // namespace oplus
