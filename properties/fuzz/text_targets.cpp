// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/reader_check.hpp"
#include "properties/fuzz/text_mutation.hpp"

namespace oplus {

namespace {

template <Format format>
std::string mutated_in(Random& random, std::string_view text) {
  return mutated_text(random, text, format);
}

/// In the format of the text, as the reader tells formats apart.
std::string mutated_sum(Random& random, std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\n\r\v\f");
  if (first == std::string_view::npos) return mutated_in<Format::wkt>(random, text);
  if (text[first] == '{' || text[first] == '[') return mutated_in<Format::geojson>(random, text);
  const bool is_digit = text[first] >= '0' && text[first] <= '9';
  return is_digit ? mutated_in<Format::dat>(random, text) : mutated_in<Format::wkt>(random, text);
}

}  // namespace

const FuzzTarget dat_target{"dat", "Regions in .dat: read, refused, written and read again",
                            check_region_reader, mutated_in<Format::dat>};
const FuzzTarget wkt_target{"wkt", "Regions in WKT: read, refused, written and read again",
                            check_region_reader, mutated_in<Format::wkt>};
const FuzzTarget geojson_target{"geojson",
                                "Regions in GeoJSON: read, refused, written and read again",
                                check_region_reader, mutated_in<Format::geojson>};
const FuzzTarget sums_target{"sums", "Sums in all formats: read, refused, written and read again",
                             check_sum_reader, mutated_sum};
const FuzzTarget layouts_target{
    "layouts", "Layouts in all formats: read, refused, checked, and checked as polygons",
    check_layout_reader, nullptr};

}  // namespace oplus
