// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/built_regions.hpp"

#include <gtest/gtest.h>

#include "reference/chains/validity.hpp"
#include "reference/io/writing.hpp"

namespace oplus::smt {
namespace {

std::vector<Vector> small_vectors() {
  std::vector<Vector> all;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      if (x != 0 || y != 0) all.push_back({x, y});
  return all;
}

TEST(RegionWithCorner, IsValidAndHasTheCornersSector) {
  const Rational little(1, 100);
  for (const Vector& in : small_vectors()) {
    for (const Vector& out : small_vectors()) {
      const Region region = region_with_corner({in, out});
      ASSERT_TRUE(!find_defect(region)) << to_string(in) << to_string(out);
      for (const Vector& d : small_vectors()) {
        const bool is_inside =
            counterclockwise_between({d, Summand::P}, {out, Summand::P}, {-in, Summand::P});
        ASSERT_EQ(locate(little * d, region) == Location::inside, is_inside)
            << to_string(in) << to_string(out) << to_string(d);
      }
    }
  }
}

TEST(RegionWithEdge, IsValidAndFillsTheHalfDisk) {
  for (const Vector& edge : small_vectors()) {
    const Region region = region_with_edge(edge, 5);
    ASSERT_TRUE(!find_defect(region)) << to_string(edge);
    for (const Vector& d : small_vectors()) {
      ASSERT_EQ(locate(d, region), sign(cross(edge, d)) > 0   ? Location::inside
                                   : sign(cross(edge, d)) < 0 ? Location::outside
                                                              : Location::boundary)
          << to_string(edge) << to_string(d);
    }
  }
}

}  // namespace
}  // namespace oplus::smt
