// SPDX-License-Identifier: MIT
#include <utility>

#include "checked/operations/image.hpp"
#include "checked/operations/union_of.hpp"
#include "checked/oplus/oplus.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

namespace {

PlanarSet value_of(const ReadSet& set) {
  return set.segments.empty() && set.points.empty()
             ? canonical_sum(set.region)
             : union_of(set.region, set.segments, set.points);
}

}  // namespace

ClosedSet::ClosedSet(const ValidRegion& region) : value_(canonical_sum(region.region())) {}

ClosedSet::ClosedSet(const ValidRegion& region,
                     const std::vector<std::vector<Coordinates>>& polylines,
                     const std::vector<Coordinates>& points) {
  ReadSet set{region.region(), {}, {}, {}};
  for (const Coordinates& p : points) set.points.push_back(p.point());
  for (const std::vector<Coordinates>& line : polylines) {
    if (line.size() == 1) set.points.push_back(line[0].point());
    for (std::size_t i = 1; i < line.size(); ++i)
      set.segments.push_back({line[i - 1].point(), line[i].point()});
  }
  value_ = value_of(set);
}

ClosedSet read_set(const std::string& text) { return ClosedSet(value_of(read_set(text, "text"))); }

ClosedSet read_set_file(const std::string& path) {
  return ClosedSet(value_of(read_set_file(path, {})));
}

ClosedSet operator-(const ClosedSet& set) { return ClosedSet(image({-1, 0, 0, -1}, set.value())); }

}  // namespace oplus
