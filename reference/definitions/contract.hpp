// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace oplus {

/// A broken pre- or postcondition: a bug in oplus or in the code that calls it, never bad input.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace oplus

/// OPLUS_REQUIRES(condition, statement) and OPLUS_ENSURES(condition, statement): contracts named
/// after the statement of the thesis they express. Checked in the presets `check` and `fuzz`.
#ifdef OPLUS_CONTRACTS
#define OPLUS_CONTRACT(kind, condition, statement)                                     \
  do {                                                                                 \
    if (!(condition))                                                                  \
      throw ::oplus::ContractViolation(std::string(kind " (" statement ") broken: ") + \
                                       #condition + " at " __FILE__ ":" +              \
                                       std::to_string(__LINE__));                      \
  } while (false)
#else
#define OPLUS_CONTRACT(kind, condition, statement) static_cast<void>(0)
#endif
#define OPLUS_REQUIRES(condition, statement) OPLUS_CONTRACT("precondition", condition, statement)
#define OPLUS_ENSURES(condition, statement) OPLUS_CONTRACT("postcondition", condition, statement)
