// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/reader_check.hpp"
#include "properties/fuzz/text_mutation.hpp"

namespace oplus {

const FuzzTarget& wkt_target() {
  static const FuzzTarget target{
      "wkt",
      "Regions in WKT: read, refused, written and read again",
      check_region_reader,
      [](Random& random, std::string_view text) { return mutated_text(random, text, Format::wkt); },
      crossed_text,
      2048};
  return target;
}

}  // namespace oplus
