// SPDX-License-Identifier: MIT
#pragma once

/// OPLUS_MUTANT("name", "what goes wrong") is true where the fault of that name is switched on. Only
/// the preset `check` contains mutants; elsewhere the macro is the constant false and neither string
/// is compiled. A fault that is in several places is described in one of them:
/// properties/mutants/list_mutants.py makes the list.
#ifdef OPLUS_MUTANTS
#include <string>
#include <string_view>

namespace oplus {

/// The one mutant that is switched on, or empty. Set before a run, by `oplus-maintain mutants` only.
inline std::string active_mutant;

}  // namespace oplus

#define OPLUS_MUTANT(name, ...) (::oplus::active_mutant == std::string_view(name))
#else
#define OPLUS_MUTANT(name, ...) false
#endif
