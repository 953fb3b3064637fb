// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <ostream>

// What tests print numbers by: Debian's GMP has it for libstdc++, not for libc++.
std::ostream& operator<<(std::ostream& out, mpz_srcptr number) {
  return out << mpz_class(number).get_str();
}
std::ostream& operator<<(std::ostream& out, mpq_srcptr number) {
  return out << mpq_class(number).get_str();
}
