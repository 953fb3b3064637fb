// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/reader_check.hpp"
#include "properties/fuzz/text_mutation.hpp"

namespace oplus {

namespace {

/// As the reader tells formats apart.
Format format_of_text(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\n\r\v\f");
  if (first == std::string_view::npos) return Format::wkt;
  if (text[first] == '{' || text[first] == '[') return Format::geojson;
  const bool is_digit = text[first] >= '0' && text[first] <= '9';
  return is_digit ? Format::dat : Format::wkt;
}

}  // namespace

const FuzzTarget& sums_target() {
  static const FuzzTarget target{"sums",
                                 "Sums in all formats: read, refused, written and read again",
                                 check_sum_reader,
                                 [](Random& random, std::string_view text) {
                                   return mutated_text(random, text, format_of_text(text));
                                 },
                                 crossed_text,
                                 2048};
  return target;
}

}  // namespace oplus
