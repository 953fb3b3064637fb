// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/reader_check.hpp"
#include "properties/fuzz/text_mutation.hpp"

namespace oplus {

const FuzzTarget& geojson_target() {
  static const FuzzTarget target{"geojson",
                                 "Regions in GeoJSON: read, refused, written and read again",
                                 check_region_reader,
                                 [](Random& random, std::string_view text) {
                                   return mutated_text(random, text, Format::geojson);
                                 },
                                 crossed_text,
                                 2048};
  return target;
}

}  // namespace oplus
