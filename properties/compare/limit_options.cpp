// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/limit_options.hpp"

namespace oplus {

void add_limit_options(CLI::App& command, PeerLimits& limits) {
  command.add_option("--time-limit", limits.seconds, "Seconds that another's engine has for a sum")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--memory-limit", limits.memory_mb, "Address space that it has, in MB; 0: any")
      ->capture_default_str();
}

}  // namespace oplus
