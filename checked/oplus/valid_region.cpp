// SPDX-License-Identifier: MIT
#include <utility>

#include "checked/operations/union_of.hpp"
#include "checked/oplus/oplus.hpp"
#include "checked/repair/repair.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/region.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

namespace {

Chain chain_of(const std::vector<Coordinates>& points) {
  Chain chain;
  chain.reserve(points.size());
  for (const Coordinates& p : points) chain.push_back(p.point());
  return chain;
}

/// Throws InvalidInput where a denominator is zero. Integers stay as they are, not copied.
Region in_lowest_terms(Region region) {
  const auto put = [](Rational& c) {
    if (c.get_den() != 1) c = Number(c).value();
  };
  const auto put_all = [&](Chain& chain) {
    for (Point& p : chain) {
      put(p.x);
      put(p.y);
    }
  };
  for (Component& component : region.components) {
    put_all(component.outer);
    for (Chain& hole : component.holes) put_all(hole);
  }
  return region;
}

Region in_one(ReadRegion read, Overlaps overlaps) {
  if (overlaps == Overlaps::refused) return std::move(read.region);
  return region_of(union_of(read.region));
}

}  // namespace

ValidRegion::ValidRegion(Region region)
    : ValidRegion(checked(in_lowest_terms(std::move(region)))) {}

bool operator==(const ValidRegion& a, const ValidRegion& b) {
  return a.region() == b.region() || canonical_sum(a.region()) == canonical_sum(b.region());
}

ValidRegion ValidRegion::checked(Region region) {
  return found_valid(oriented_and_checked(std::move(region), "region").region);
}

ValidRegion ValidRegion::found_valid(Region region) {
  ValidRegion result;
  result.region_ = std::move(region);
  return result;
}

ValidRegion polygon(const std::vector<Coordinates>& outer,
                    const std::vector<std::vector<Coordinates>>& holes) {
  Component component{chain_of(outer), {}};
  for (const std::vector<Coordinates>& hole : holes) component.holes.push_back(chain_of(hole));
  return ValidRegion::checked(Region{{std::move(component)}});
}

ValidRegion read_wkt(const std::string& text, Overlaps overlaps) {
  return ValidRegion::found_valid(
      in_one(read_region_in(Format::wkt, text, "WKT", overlaps), overlaps));
}

ValidRegion read_geojson(const std::string& text, Overlaps overlaps) {
  return ValidRegion::found_valid(
      in_one(read_region_in(Format::geojson, text, "GeoJSON", overlaps), overlaps));
}

ValidRegion read_text(const std::string& text, Overlaps overlaps) {
  return ValidRegion::found_valid(
      in_one(read_region(text, "text", {}, Extent::any, overlaps), overlaps));
}

ValidRegion read_file(const std::string& path, Overlaps overlaps) {
  return ValidRegion::found_valid(
      in_one(read_region_file(path, {}, Extent::any, overlaps), overlaps));
}

Repaired repaired(Region region, std::optional<FillRule> fill) {
  RepairedRegion result = repaired(unchecked(in_lowest_terms(std::move(region)), "region"), fill);
  return {ValidRegion::found_valid(std::move(result.region)), std::move(result.mends)};
}

Repaired repaired_text(const std::string& text, std::optional<FillRule> fill) {
  RepairedRegion result = repaired(read_unchecked(text, "text"), fill);
  return {ValidRegion::found_valid(std::move(result.region)), std::move(result.mends)};
}

Repaired repaired_file(const std::string& path, std::optional<FillRule> fill) {
  RepairedRegion result = repaired(read_unchecked_file(path), fill);
  return {ValidRegion::found_valid(std::move(result.region)), std::move(result.mends)};
}

ValidRegion operator-(const ValidRegion& region) {
  return ValidRegion::found_valid(reflected(region.region()));
}

bool is_unbounded(const ValidRegion& region) { return is_unbounded(region.region()); }

Rational area(const ValidRegion& region) { return area(region.region()); }

Location locate(const Coordinates& point, const ValidRegion& region) {
  return locate(point.point(), region.region());
}

bool contains(const ValidRegion& region, const Coordinates& point) {
  return locate(point, region) != Location::outside;
}

}  // namespace oplus
