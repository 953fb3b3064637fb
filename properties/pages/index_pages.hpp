// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/pages/theorem_page.hpp"

namespace oplus {

/// docs/theorems.md: all statements, chapter by chapter.
Page theorems_page(const Registry& registry);

/// docs/mutants.md: which statements kill which mutant, after how many cases.
Page mutants_page(const Registry& registry);

/// docs/theorems/graph.md: the drawing of graph.dot, and what its colours mean.
Page graph_page();

}  // namespace oplus
