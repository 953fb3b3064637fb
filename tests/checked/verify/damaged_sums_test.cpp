// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "checked/slide/slide.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/families/family.hpp"
#include "tests/checked/verify/damage.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

/// Membership as the test understands it: rays through all chains of a component, nonzero. Points on
/// a chain are outside.
bool is_inside(const Point& x, const ClaimedSum& given) {
  for (const Component& component : given.region.components) {
    bool inside =
        !lies_on_one(x, edges(component.outer)) && winding_number(x, edges(component.outer)) != 0;
    for (const Chain& hole : component.holes)
      inside = inside && !lies_on_one(x, edges(hole)) && winding_number(x, edges(hole)) == 0;
    if (inside) return true;
  }
  return false;
}

bool is_set_reason(ReasonKind kind) { return kind < ReasonKind::wrong_orientation; }

/// That the damage is one, and the first reason true: none of it asks the verifier.
void expect_true(const Reason& reason, const ClaimedSum& given, const PlanarSet& sum,
                 const Region& p, const Region& q) {
  const Point& x = reason.witness;
  const bool meet = interiors_meet(p, translated(reflected(q), x));
  if (is_set_reason(reason.kind)) {
    EXPECT_NE(reason.in_sum, reason.in_given);
    EXPECT_EQ(meet, reason.in_sum);
    EXPECT_EQ(is_inside(x, given), reason.in_given);
    EXPECT_EQ(locate(x, sum), reason.in_sum ? Location::inside : Location::outside);
    return;
  }
  std::vector<Segment> drawn = edges(given.region);
  const std::vector<Segment> right = edges(sum);
  const auto times_on = [&](const std::vector<Segment>& all) {
    return std::count_if(all.begin(), all.end(), [&](const Segment& e) { return lies_on(x, e); });
  };
  switch (reason.kind) {
    case ReasonKind::wrong_orientation: {
      // The chain that runs there runs as none of the sum's does.
      const auto is_turned = [&](const Segment& e) {
        return lies_on(x, e) && std::any_of(right.begin(), right.end(), [&](const Segment& r) {
                 return lies_on(x, r) && sign(dot(direction_of(e), direction_of(r))) < 0 &&
                        sign(cross(direction_of(e), direction_of(r))) == 0;
               });
      };
      EXPECT_TRUE(std::any_of(drawn.begin(), drawn.end(), is_turned));
      break;
    }
    case ReasonKind::unsimple_boundary:
      EXPECT_NE(times_on(drawn), times_on(right));
      break;
    case ReasonKind::missing_dangling_edge:
    case ReasonKind::missing_isolated_vertex:
      EXPECT_FALSE(meet);
      EXPECT_EQ(locate(x, sum), Location::boundary);
      EXPECT_TRUE(is_inside(x, given));
      break;
    default:
      EXPECT_EQ(times_on(drawn), 0);
      EXPECT_NE(locate(x, sum), Location::boundary);
  }
}

TEST(DamagedSums, are_told_with_the_right_reason) {
  std::map<std::string, std::set<std::string>> pairs_of_damage;
  std::size_t damaged = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      const std::size_t n = std::min(family.typical, family.smallest + 3);
      const auto [p, q] = generate(family, n, seed);
      for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
        const PlanarSet sum = slide_sum(p, q, boundary).sum;
        const ClaimedSum whole = parts_of(sum);
        ASSERT_TRUE(verify(p, q, boundary, whole).is_sum()) << family.name << ' ' << seed;
        if (boundary == Boundary::open && !has_features(sum)) continue;  // as the closed one
        for (const Damage& damage : damages()) {
          ClaimedSum given = whole;
          damage.apply(given, sum);
          if (given == whole) continue;
          SCOPED_TRACE(damage.name + ", " + family.name + ", n = " + std::to_string(n) + ", seed " +
                       std::to_string(seed));
          const Verdict verdict = verify(p, q, boundary, given);
          ++damaged;
          pairs_of_damage[damage.name].insert(family.name + std::to_string(seed));
          ASSERT_FALSE(verdict.is_sum());
          EXPECT_TRUE(
              std::any_of(verdict.reasons.begin(), verdict.reasons.end(),
                          [&](const Reason& r) { return damage.right_reasons.contains(r.kind); }))
              << describe(verdict.reasons.front().kind) << ": " << verdict.reasons.front().detail;
          const Reason& first = verdict.reasons.front();
          expect_true(first, given, sum, p, q);
          EXPECT_EQ(verdict.addends.has_value(), first.in_sum);
          if (verdict.addends) {
            EXPECT_EQ(verdict.addends->p + verdict.addends->q, first.witness);
            EXPECT_NE(locate(verdict.addends->p, p), Location::outside);
            EXPECT_NE(locate(verdict.addends->q, q), Location::outside);
          }
        }
      }
    }
  }
  EXPECT_GT(damaged, 400U);
  for (const Damage& damage : damages())
    EXPECT_GE(pairs_of_damage[damage.name].size(), 2U) << damage.name << " is hardly tried";
}

}  // namespace
}  // namespace oplus
