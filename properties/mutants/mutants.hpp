// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace oplus {

/// A fault that can be switched on in the preset `check` (reference/definitions/mutant.hpp).
struct Mutant {
  std::string name;
  std::string what;  ///< what goes wrong, a line
  std::string file;  ///< from the root
};

/// All mutants, by their names; list_mutants.py collects them from the sources.
const std::vector<Mutant>& mutants();

}  // namespace oplus
