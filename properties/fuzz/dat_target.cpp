// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/reader_check.hpp"
#include "properties/fuzz/text_mutation.hpp"

namespace oplus {

const FuzzTarget& dat_target() {
  static const FuzzTarget target{
      "dat",
      "Regions in .dat: read, refused, written and read again",
      check_region_reader,
      [](Random& random, std::string_view text) { return mutated_text(random, text, Format::dat); },
      crossed_text,
      2048};
  return target;
}

}  // namespace oplus
