// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion bin = polygon({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
const ValidRegion part = polygon({{0, 0}, {10, 0}, {10, 100}, {0, 100}});

TEST(Operations, are_sets_with_their_boundary) {
  EXPECT_EQ(nfp(bin, part).boundary(), Boundary::open);
  const ValidSet places = ifp(bin, part);
  EXPECT_EQ(places.boundary(), Boundary::closed);
  EXPECT_TRUE(contains(places, {45, 0}));
  EXPECT_FALSE(contains(places, {45, 1}));
}

TEST(Operations, take_threads) { EXPECT_EQ(ifp(bin, part, {.threads = 2}), ifp(bin, part)); }

TEST(Complement, is_unbounded) {
  const ValidRegion outside = complement(bin);
  EXPECT_TRUE(is_unbounded(outside));
  EXPECT_FALSE(is_unbounded(bin));
  EXPECT_EQ(complement(outside), bin);
  EXPECT_EQ(area(outside), -10000);
  EXPECT_TRUE(contains(outside, {1000, 1}));
  EXPECT_FALSE(contains(outside, {50, 50}));
  EXPECT_EQ(locate({0, 50}, outside), Location::boundary);
}

TEST(Complement, of_an_open_set_is_closed) {
  const ValidSet places = ifp(bin, part);
  const ValidSet rest = complement(places);
  EXPECT_EQ(rest.boundary(), Boundary::open);
  EXPECT_TRUE(contains(rest, {1000, 1}));
  EXPECT_FALSE(contains(rest, {45, 0}));
  EXPECT_EQ(rest.dangling_edges(), places.dangling_edges());
  EXPECT_EQ(complement(rest), places);
}

TEST(Unbounded, refused_where_it_makes_no_sense) {
  const ValidRegion free = complement(bin);
  EXPECT_THROW(minkowski_sum(free, part, {.with_origins = true}), InvalidInput);
  EXPECT_THROW(verify(free, part, ValidSet()), InvalidInput);
  EXPECT_THROW(verify(part, free, ClaimedSum{}), InvalidInput);
  EXPECT_THROW(verify(part, part, minkowski_sum(free, part)), InvalidInput);
  EXPECT_THROW(to_wkt(free), std::invalid_argument);
  EXPECT_THROW(to_geojson(minkowski_sum(free, part)), std::invalid_argument);
}

}  // namespace
}  // namespace oplus
