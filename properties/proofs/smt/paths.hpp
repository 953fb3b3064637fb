// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "properties/proofs/smt/formula.hpp"

namespace oplus::smt {

/// When code answers "true", as a formula in the unknowns. The code is run once for each way through
/// its comparisons, each of which is answered "yes" in one run and "no" in another, unless what was
/// answered before settles it.
/// Requires: the code ends whatever is answered, and depends on nothing else. Not to be nested.
Formula executed(const std::function<bool()>& code);

/// Inside `executed` only, unless the answer is known: asks which.
bool is_among(const Term& term, const Signs& signs);
bool is_set(const std::string& flag);

inline bool operator<(const Term& a, const Term& b) { return is_among(a - b, {.negative = true}); }
inline bool operator>(const Term& a, const Term& b) { return b < a; }
inline bool operator<=(const Term& a, const Term& b) { return !(b < a); }
inline bool operator>=(const Term& a, const Term& b) { return !(a < b); }
inline bool operator==(const Term& a, const Term& b) { return is_among(a - b, {.zero = true}); }

inline int sign(const Term& term) { return term < 0 ? -1 : term == 0 ? 0 : 1; }
inline int cmp(const Term& a, const Term& b) { return sign(a - b); }

}  // namespace oplus::smt
