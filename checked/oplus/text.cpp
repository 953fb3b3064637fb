// SPDX-License-Identifier: MIT
#include "checked/oplus/oplus.hpp"
#include "reference/io/power_of_ten.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string text(const PlanarSet& features, const ValidRegion& region, Format format) {
  if (is_unbounded(region))
    throw std::invalid_argument("the region is unbounded, which only .dat can hold");
  std::string result = written(features, region.region(), format);
  if (result.ends_with('\n')) result.pop_back();
  return result;
}

/// Requires of the number of digits what callers promise.
Number step_of(int digits) {
  if (digits < 0 || digits > most_digits)
    throw std::invalid_argument("digits: " + std::to_string(digits) + "; expected 0 to " +
                                std::to_string(most_digits));
  return Rational(1) / Rational(power_of_ten(static_cast<std::size_t>(digits)));
}

std::string text(const ValidRegion& region, Format format, std::optional<int> digits) {
  return digits ? text({}, rounded(region, step_of(*digits)).sum.region(), format)
                : text({}, region, format);
}

std::string text(const ValidSet& exact, Format format, std::optional<int> digits) {
  const ValidSet sum = digits ? rounded(exact, step_of(*digits)).sum : exact;
  return text(sum.value(), sum.region(), format);
}

void require_doubles(const std::optional<Rational>& value) {
  if (value)
    throw InvalidInput({"WKB", 0, 0}, to_string(*value) + " is not a double",
                       "coordinates that are exactly doubles");
}

}  // namespace

std::string to_wkt(const ValidRegion& region, std::optional<int> digits) {
  return text(region, Format::wkt, digits);
}

std::string to_wkt(const ValidSet& sum, std::optional<int> digits) {
  return text(sum, Format::wkt, digits);
}

std::string to_geojson(const ValidRegion& region, std::optional<int> digits) {
  return text(region, Format::geojson, digits);
}

std::string to_geojson(const ValidSet& sum, std::optional<int> digits) {
  return text(sum, Format::geojson, digits);
}

std::string to_wkb(const ValidRegion& region) {
  require_doubles(not_a_double(region.region(), {}));
  return text({}, region, Format::wkb);
}

std::string to_wkb(const ValidSet& sum) {
  require_doubles(not_a_double(sum.region().region(), sum.value()));
  return text(sum.value(), sum.region(), Format::wkb);
}

std::string to_dat(const ValidRegion& region) { return written(region.region(), Format::dat); }

std::string to_dat(const ValidSet& set) {
  if (!can_hold(Format::dat, set.value()))
    throw std::invalid_argument(
        "the set has dangling edges or isolated vertices, which .dat cannot hold");
  return to_dat(set.region());
}

}  // namespace oplus
