// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/values_in_words.hpp"

#include "properties/compare/failure_kind.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

std::string in_words(const Region& region) {
  return written(region, is_unbounded(region) ? Format::dat : Format::wkt);
}

std::string in_words(const PlanarSet& sum) {
  if (can_hold(Format::wkt, sum) && !malformed(sum)) return written(sum, Format::wkt);
  std::string text = sum.is_unbounded ? "unbounded\n" : "";
  const auto add = [&](const std::string& what, const Chain& points) {
    text += what;
    for (const Point& p : points) text += " " + to_string(p);
    text += "\n";
  };
  for (const Chain& chain : sum.outer) add("outer chain", chain);
  for (const Chain& chain : sum.holes) add("hole", chain);
  for (const Segment& s : sum.dangling_edges) add("dangling edge", {s.source, s.target});
  for (const Point& p : sum.isolated_vertices) add("isolated vertex", {p});
  return text;
}

}  // namespace oplus
