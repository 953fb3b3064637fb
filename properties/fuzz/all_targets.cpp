// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/all_targets.hpp"

#include <algorithm>

namespace oplus {

const std::vector<FuzzTarget>& fuzz_targets() {
  static const std::vector<FuzzTarget> all{dat_target(), wkt_target(), geojson_target(),
                                           sums_target(), slide_target()};
  return all;
}

const FuzzTarget* find_fuzz_target(const std::string& name) {
  const auto found = std::find_if(fuzz_targets().begin(), fuzz_targets().end(),
                                  [&](const FuzzTarget& target) { return target.name == name; });
  return found == fuzz_targets().end() ? nullptr : &*found;
}

}  // namespace oplus
