// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace oplus {

/// Tells crashes apart by what a program wrote to standard error before it ended: the assertion that
/// failed, CGAL's with its file from include/ on, as "FILE:LINE: EXPRESSION"; what a sanitizer found;
/// the type of an uncaught exception. Otherwise how it ended, such as "SIGSEGV".
std::string crash_site(const std::string& errors, const std::string& how_it_ended);

/// Whether a program that failed says that memory was the reason: std::bad_alloc, GMP, strerror's
/// "Cannot allocate memory", Python's MemoryError and the like.
bool says_out_of_memory(const std::string& errors);

}  // namespace oplus
