// SPDX-License-Identifier: MIT
#include <utility>

#include "checked/oplus/oplus.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

namespace {

Chain chain_of(const std::vector<Coordinates>& points) {
  Chain chain;
  chain.reserve(points.size());
  for (const Coordinates& p : points) chain.push_back(p.point());
  return chain;
}

}  // namespace

ValidRegion::ValidRegion(Region region)
    : ValidRegion(checked(
          mapped(std::move(region), [](const Point& p) { return Coordinates(p).point(); }))) {}

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

ValidRegion read_wkt(const std::string& text) {
  return ValidRegion::found_valid(read_region_in(Format::wkt, text, "WKT").region);
}

ValidRegion read_geojson(const std::string& text) {
  return ValidRegion::found_valid(read_region_in(Format::geojson, text, "GeoJSON").region);
}

ValidRegion read_file(const std::string& path) {
  return ValidRegion::found_valid(read_region_file(path).region);
}

ValidRegion operator-(const ValidRegion& region) {
  return ValidRegion::found_valid(reflected(region.region()));
}

Rational area(const ValidRegion& region) { return area(region.region()); }

Location locate(const Coordinates& point, const ValidRegion& region) {
  return locate(point.point(), region.region());
}

bool contains(const ValidRegion& region, const Coordinates& point) {
  return locate(point, region) != Location::outside;
}

}  // namespace oplus
