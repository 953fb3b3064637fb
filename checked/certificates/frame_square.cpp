// SPDX-License-Identifier: MIT
#include "checked/certificates/frame_square.hpp"

#include <algorithm>

namespace oplus::certificates {

Rational frame_size(const std::vector<const Region*>& regions) {
  Rational size = 1;
  for (const Region* region : regions)
    each_vertex(*region, [&](const Point& v) {
      size = std::max({size, Rational(abs(v.x)), Rational(abs(v.y))});
    });
  return size;
}

Chain square(const Rational& k) { return {{-k, -k}, {k, -k}, {k, k}, {-k, k}}; }

Region complement_in_square(const Rational& k, const Region& region) {
  Component result{square(k), {}};
  for (const Chain& chain : chains(region)) result.holes.push_back(turned(chain));
  return {{std::move(result)}};
}

}  // namespace oplus::certificates
