// SPDX-License-Identifier: MIT
#include "checked/operations/image.hpp"
#include "checked/operations/union_of.hpp"
#include "checked/oplus/internal/sum_options.hpp"
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

PlanarSet union_of_all(const ValidRegion& region,
                       const std::vector<std::vector<Coordinates>>& polylines,
                       const std::vector<Coordinates>& points) {
  ReadSet set{region.region(), {}, {}, {}};
  for (const Coordinates& p : points) set.points.push_back(p.point());
  for (const std::vector<Coordinates>& line : polylines) {
    if (line.size() == 1) set.points.push_back(line[0].point());
    for (std::size_t i = 1; i < line.size(); ++i)
      set.segments.push_back({line[i - 1].point(), line[i].point()});
  }
  return value_of(set);
}

}  // namespace

ValidSet::ValidSet(const ValidRegion& region)
    : ValidSet(canonical_sum(region.region()), Boundary::closed, {}, {}) {}

ValidSet::ValidSet(const ValidRegion& region,
                   const std::vector<std::vector<Coordinates>>& polylines,
                   const std::vector<Coordinates>& points)
    : ValidSet(union_of_all(region, polylines, points), Boundary::closed, {}, {}) {}

ValidSet read_set(const std::string& text) {
  return set_of(value_of(read_set(text, "text")), Boundary::closed);
}

ValidSet read_set_file(const std::string& path) {
  return set_of(value_of(read_set_file(path, {})), Boundary::closed);
}

ClaimedSum read_claimed_sum(const std::string& text) { return read_unchecked_sum(text, "text"); }

ValidSet operator-(const ValidSet& set) {
  return set_of(image({-1, 0, 0, -1}, set.value()), set.boundary());
}

}  // namespace oplus
