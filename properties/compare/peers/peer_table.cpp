// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/peer_table.hpp"

#include <algorithm>

namespace oplus {

const std::vector<Peer>& peers() {
  constexpr Arithmetic exact = Arithmetic::exact;
  constexpr Arithmetic rounding = Arithmetic::rounding;
  static const std::vector<Peer> all{
      {"cgal-reduced", "CGAL's reduced convolution; one component, holes", exact},
      {"cgal-full", "CGAL's full convolution; one component, no holes", exact},
      {"cgal-vertical", "CGAL, by vertical decomposition; one component, holes", exact},
      {"cgal-triangulation", "CGAL, by triangulation; one component, holes", exact},
      {"cgal-small-side", "CGAL, by small side angle bisectors; one component, no holes", exact},
      {"cgal-optimal", "CGAL, by optimal convex decomposition; one component, no holes", exact},
      {"cgal-hertel-mehlhorn",
       "CGAL, by Hertel and Mehlhorn's decomposition; one component, no holes", exact},
      {"cgal-greene", "CGAL, by Greene's decomposition; one component, no holes", exact},
      {"clipper",
       "Clipper 6, filled by the larger summand; one component, holes in the larger summand; rounds",
       rounding},
      {"boost-polygon", "Boost.Polygon's convolution of polygon sets; any region; rounds",
       rounding},
  };
  return all;
}

const Peer* find_peer(const std::string& name) {
  const std::vector<Peer>& all = peers();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Peer& peer) { return peer.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace oplus
