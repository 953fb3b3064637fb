// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/peer_table.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "properties/compare/peers/sum_of_chains.hpp"

namespace oplus {
namespace {

ReturnedChains chains_in(const std::string& line, const Rational& scale) {
  ReturnedChains chains;
  std::istringstream path(line);
  Rational x, y;
  for (char command = 0; path >> command;) {
    if (command == 'Z') continue;
    if (command == 'M') chains.emplace_back();
    path >> x >> y;
    chains.back().push_back({x / scale, y / scale});
  }
  return chains;
}

// The second part in halves, and with a corner that others go round clockwise.
const std::vector<Region> parts = {
    polygon({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {0, 1}}),
    polygon({{0, 0}, {Rational(1, 2), 0}, {Rational(1, 2), 1}, {-1, 1}})};

void expect_no_fit_polygons(const Peer& peer) {
  std::stringstream lines;
  peer.no_fit_polygons(parts, lines);
  Rational scale;
  lines >> scale >> std::ws;
  EXPECT_EQ(scale.get_den(), 1);
  EXPECT_GE(scale, 2);
  for (const Region& p : parts)
    for (const Region& q : parts) {
      std::string line;
      std::getline(lines, line);
      EXPECT_EQ(sum_of_chains(chains_in(line, scale)), sum_of_chains(peer.sum({p, reflected(q)})))
          << line;
    }
  EXPECT_EQ(lines.peek(), EOF);
}

TEST(NoFitPolygons, are_the_sums_of_P_and_the_reflected_Q_in_both_orders) {
  for (const Peer& peer : {cgal_reduced(), cgal_small_side(), boost_polygon(), clipper()})
    expect_no_fit_polygons(peer);
}

TEST(NoFitPolygons, are_refused_where_a_part_is) {
  std::vector<Region> two = parts;
  two[0].components.push_back(polygon({{9, 9}, {10, 9}, {9, 10}}).components[0]);
  std::ostringstream out;
  EXPECT_THROW(cgal_reduced().no_fit_polygons(two, out), Unsupported);
}

}  // namespace
}  // namespace oplus
