// SPDX-License-Identifier: MIT
#include "checked/oplus/oplus.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string text(const MinkowskiSum& features, const ValidRegion& region, Format format,
                 std::optional<int> digits) {
  if (digits && (*digits < 0 || *digits > most_digits))
    throw std::invalid_argument("digits: " + std::to_string(*digits) + "; expected 0 to " +
                                std::to_string(most_digits));
  std::string result = written(features, region.region(), format, digits);
  if (result.ends_with('\n')) result.pop_back();
  return result;
}

}  // namespace

std::string to_wkt(const ValidRegion& region, std::optional<int> digits) {
  return text({}, region, Format::wkt, digits);
}

std::string to_wkt(const Sum& sum, std::optional<int> digits) {
  return text(sum.value(), sum.region(), Format::wkt, digits);
}

std::string to_geojson(const ValidRegion& region, std::optional<int> digits) {
  return text({}, region, Format::geojson, digits);
}

std::string to_geojson(const Sum& sum, std::optional<int> digits) {
  return text(sum.value(), sum.region(), Format::geojson, digits);
}

}  // namespace oplus
