// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/written.hpp"

#include <sstream>

namespace oplus {

namespace {

template <typename Value>
std::string written_value(const Value& value, Format format) {
  std::ostringstream out;
  write(out, value, format);
  return out.str();
}

std::string without_line_end(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

std::string written(const Region& region, Format format) { return written_value(region, format); }
std::string written(const MinkowskiSum& sum, Format format) { return written_value(sum, format); }

std::string wkt(const Region& region) { return without_line_end(written(region, Format::wkt)); }
std::string wkt(const MinkowskiSum& sum) { return without_line_end(written(sum, Format::wkt)); }

}  // namespace oplus
