// SPDX-License-Identifier: MIT
#include "checked/certificates/frame_square.hpp"

#include <algorithm>

namespace oplus::certificates {

Rational frame_size(const std::vector<const Region*>& regions) {
  Rational size = 1;
  for (const Region* region : regions)
    for (const Chain& chain : chains(*region))
      for (const Point& v : chain) size = std::max({size, Rational(abs(v.x)), Rational(abs(v.y))});
  return size;
}

Chain square(const Rational& k) { return {{-k, -k}, {k, -k}, {k, k}, {-k, k}}; }

Chain turned(const Chain& chain) {
  Chain result = chain;
  if (!result.empty()) std::reverse(result.begin() + 1, result.end());
  return result;
}

Region complement_in_square(const Rational& k, const Region& region) {
  Component result{square(k), {}};
  for (const Chain& chain : chains(region)) result.holes.push_back(turned(chain));
  return {{std::move(result)}};
}

}  // namespace oplus::certificates
