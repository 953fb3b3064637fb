// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "properties/statements/chapter5/boundary_contact.hpp"
#include "properties/statements/laws/linear_map.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/validity.hpp"
#include "tests/checked/collision/collision_methods.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

using Contact = BoundaryContact;

/// b moved by x, its strongest contact with a, and whether the interiors meet.
struct Placement {
  std::string name;
  Point x;
  Contact contact;
  bool meet;
};

/// Two regions and places for the second, asked one after the other of one collision test.
struct Pair {
  std::string name;
  Region a;
  Region b;
  std::vector<Placement> placements;
};

const Region square = polygon(box(0, 0, 4, 4));
const Region diamond = polygon({{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
const Region frame{{{box(0, 0, 6, 6), {backwards(box(2, 2, 4, 4))}}}};
const Region two_squares{{{box(0, 0, 2, 2), {}}, {box(4, 0, 6, 2), {}}}};
const Region corner_to_corner{{{box(0, 0, 2, 2), {}}, {box(2, 2, 4, 4), {}}}};
/// Its vertex at the origin has a convex interior angle, from 0 to 90 degrees.
const Region wedge = polygon({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}});
/// Its vertex at the origin is reflex: the wedge's quadrant is outside.
const Region notched = polygon({{0, 0}, {0, 3}, {-3, 3}, {-3, -3}, {3, -3}, {3, 0}});
/// A bar with collinear vertices where an upright bar from 1 to 2 goes over its sides.
const Region bar_with_vertices =
    polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}});

std::vector<Pair> pairs() {
  return {
      {"squares",
       square,
       square,
       {{"apart", {9, 9}, Contact::none, false},
        {"corners cross", {2, 1}, Contact::crossing, true},
        {"identical", {0, 0}, Contact::same, true},
        {"side by side", {4, 0}, Contact::opposite, false},
        {"side by side, moved along", {4, 3}, Contact::opposite, false},
        {"corner to corner", {4, 4}, Contact::weak, false},
        {"moved along a side", {1, 0}, Contact::same, true},
        {"moved along a side the other way", {0, -1}, Contact::same, true},
        {"moved out of reach", {0, -5}, Contact::none, false},
        {"identical again", {0, 0}, Contact::same, true}}},
      {"square and diamond",
       square,
       diamond,
       {{"vertex on edge from outside", {5, 2}, Contact::weak, false},
        {"vertex on edge from inside", {3, 2}, Contact::weak, true},
        {"vertices on edge, half outside", {4, 2}, Contact::weak, true},
        {"vertex pokes in", {Rational(9, 2), 2}, Contact::crossing, true},
        {"vertex on vertex from outside", {5, 4}, Contact::weak, false},
        {"vertex on vertex, one edge inside", {4, 3}, Contact::weak, true},
        {"around a vertex", {4, 4}, Contact::weak, true},
        {"edge over vertex from outside", {Rational(9, 2), Rational(9, 2)}, Contact::weak, false},
        {"inside without contact", {2, 2}, Contact::none, true},
        {"outside without contact", {7, 2}, Contact::none, false}}},
      {"containment the other way",
       diamond,
       polygon(box(-4, -4, 4, 4)),
       {{"inside without contact", {0, 0}, Contact::none, true},
        {"inside, touching", {3, 0}, Contact::weak, true},
        {"outside, touching", {5, 0}, Contact::weak, false},
        {"outside without contact", {9, 0}, Contact::none, false}}},
      {"axis-parallel cross without a proper crossing",
       bar_with_vertices,
       polygon(box(1, -1, 2, 2)),
       {{"each crossing at a vertex", {0, 0}, Contact::weak, true},
        {"some crossings at vertices", {Rational(1, 2), 0}, Contact::crossing, true},
        {"on top", {0, 2}, Contact::opposite, false},
        {"beside", {2, 0}, Contact::opposite, false},
        {"at the left end", {-1, 0}, Contact::same, true}}},
      {"bars of one height",
       polygon(box(0, 0, 3, 1)),
       polygon(box(0, 0, 3, 1)),
       {{"overlap without a proper crossing", {1, 0}, Contact::same, true},
        {"end to end", {3, 0}, Contact::opposite, false},
        {"one on the other, shifted", {1, 1}, Contact::opposite, false},
        {"end to end, past the corner", {3, 1}, Contact::weak, false}}},
      {"vertices with sectors",
       wedge,
       polygon({{0, 0}, {2, 1}, {1, 2}}),
       {{"sector in sector", {0, 0}, Contact::weak, true},
        {"in the inner corner", {1, 1}, Contact::weak, false},
        {"inside, at an edge", {Rational(3, 2), 0}, Contact::crossing, true},
        {"below", {-1, -2}, Contact::weak, false}}},
      {"sectors that lie in each other",
       polygon({{0, 0}, {4, 1}, {1, 4}}),
       polygon({{0, 0}, {2, 1}, {1, 2}}),
       {{"no other contact", {0, 0}, Contact::weak, true},
        {"apart", {4, 4}, Contact::none, false}}},
      {"sectors that overlap",
       polygon({{0, 0}, {4, 1}, {2, 4}}),
       polygon({{0, 0}, {2, 3}, {-3, 2}}),
       {{"at the vertex", {0, 0}, Contact::crossing, true}}},
      {"sectors side by side",
       polygon({{0, 0}, {4, 1}, {1, 4}}),
       polygon({{0, 0}, {1, 4}, {-2, 3}}),
       {{"a common edge between them", {0, 0}, Contact::opposite, false}}},
      {"a reflex vertex filled",
       notched,
       polygon(box(0, 0, 2, 2)),
       {{"sectors that fill the plane", {0, 0}, Contact::opposite, false},
        {"along one side", {0, Rational(1, 2)}, Contact::opposite, false},
        {"past the corner", {-1, 0}, Contact::crossing, true},
        {"over the reflex vertex", {-1, -1}, Contact::crossing, true}}},
      {"a tip in a reflex vertex",
       notched,
       polygon({{0, 0}, {2, 1}, {1, 2}}),
       {{"with room on both sides", {0, 0}, Contact::weak, false},
        {"touching one side", {0, 1}, Contact::weak, false},
        {"pushed in", {Rational(-1, 2), 0}, Contact::crossing, true}}},
      {"overlap of edges with different interiors",
       square,
       polygon({{1, 0}, {3, 0}, {2, 2}}),
       {{"same direction, inside", {0, 0}, Contact::same, true},
        {"through the opposite side", {0, 4}, Contact::opposite, false},
        {"tip on the side from below", {0, -2}, Contact::weak, false},
        {"same direction, past the corner", {2, 0}, Contact::same, true},
        {"base goes on the side's line", {3, 0}, Contact::weak, false}}},
      {"a hole",
       frame,
       polygon(box(0, 0, 1, 1)),
       {{"in the hole without contact", {Rational(5, 2), Rational(5, 2)}, Contact::none, false},
        {"in the hole, in its corner", {2, 2}, Contact::opposite, false},
        {"over the hole's side", {Rational(3, 2), Rational(5, 2)}, Contact::crossing, true},
        {"in the frame, along the hole", {1, Rational(5, 2)}, Contact::same, true},
        {"in the frame, at the hole's corner", {1, 1}, Contact::weak, true},
        {"in the frame without contact", {Rational(1, 2), Rational(5, 2)}, Contact::none, true},
        {"outside", {-3, 0}, Contact::none, false}}},
      {"a hole filled",
       frame,
       polygon(box(2, 2, 4, 4)),
       {{"exactly", {0, 0}, Contact::opposite, false},
        {"but for a ninth", {Rational(1, 9), 0}, Contact::opposite, true},
        {"in the frame's corner", {2, 2}, Contact::same, true}}},
      {"a hole over the whole",
       frame,
       polygon(box(-1, -1, 7, 7)),
       {{"all inside, no contact", {0, 0}, Contact::none, true},
        {"all inside, along a side", {1, 0}, Contact::same, true}}},
      {"frame in frame",
       Region{{{box(0, 0, 12, 12), {backwards(box(2, 2, 10, 10))}}}},
       frame,
       {{"in the hole without contact", {3, 3}, Contact::none, false},
        {"in the hole's corner", {2, 2}, Contact::opposite, false},
        {"across", {0, 3}, Contact::crossing, true},
        {"around a corner of the hole", {0, 0}, Contact::crossing, true}}},
      {"several components",
       two_squares,
       polygon(box(-1, -1, 3, 3)),
       {{"one inside, one outside", {0, 0}, Contact::none, true},
        {"the other one inside", {4, 0}, Contact::none, true},
        {"between, touching both inside corners", {1, 2}, Contact::crossing, true},
        {"above both", {1, 4}, Contact::none, false},
        {"on top of both", {1, 3}, Contact::opposite, false}}},
      {"between components",
       two_squares,
       polygon(box(0, 0, 2, 2)),
       {{"the gap filled", {2, 0}, Contact::opposite, false},
        {"the gap filled half", {2, 1}, Contact::opposite, false},
        {"one covered", {4, 0}, Contact::same, true},
        {"one touched, not the other", {Rational(3, 2), 2}, Contact::opposite, false}}},
      {"a component in a hole",
       Region{{{box(0, 0, 10, 10), {backwards(box(1, 1, 9, 9))}}, {box(4, 4, 6, 6), {}}}},
       polygon(box(0, 0, 2, 2)),
       {{"beside the island", {2, 4}, Contact::opposite, false},
        {"on the island", {4, 4}, Contact::same, true},
        {"around nothing", {Rational(3, 2), Rational(3, 2)}, Contact::none, false},
        {"in the hole's corner", {1, 1}, Contact::opposite, false}}},
      {"a component in a hole, covered",
       Region{{{box(0, 0, 10, 10), {backwards(box(1, 1, 9, 9))}}, {box(4, 4, 6, 6), {}}}},
       polygon(box(2, 2, 8, 8)),
       {{"its chain alone is inside", {0, 0}, Contact::none, true},
        {"while the other touches the hole", {1, 1}, Contact::opposite, true}}},
      {"chains that touch",
       corner_to_corner,
       polygon(box(2, 0, 4, 2)),
       {{"a free quadrant at the touching point", {0, 0}, Contact::opposite, false},
        {"the other free quadrant", {-2, 2}, Contact::opposite, false},
        {"one of its own quadrants", {0, 2}, Contact::same, true},
        {"over the touching point", {-1, 1}, Contact::crossing, true}}},
      {"four quadrants",
       corner_to_corner,
       Region{{{box(2, 0, 4, 2), {}}, {box(0, 2, 2, 4), {}}}},
       {{"the free ones", {0, 0}, Contact::opposite, false},
        {"its own", {2, 0}, Contact::same, true},
        {"corners only", {4, -4}, Contact::none, false},
        {"corner to corner", {2, -2}, Contact::opposite, false}}},
      {"edges through a touching point",
       corner_to_corner,
       polygon({{2, 2}, {3, 1}, {4, 2}, {3, 3}}),
       {{"a corner into one square", {0, 0}, Contact::weak, true},
        {"a corner at each square", {0, -1}, Contact::weak, false},
        {"an edge through both squares",
         {Rational(-1, 2), Rational(1, 2)},
         Contact::crossing,
         true}}},
      {"a slanted edge past a touching point",
       corner_to_corner,
       polygon({{1, 3}, {3, 1}, {4, 2}, {2, 4}}),
       {{"into one square", {0, 0}, Contact::weak, true}}},
      {"a half plane's edge past a touching point",
       Region{{{{{0, 0}, {2, 1}, {1, 2}}, {}}, {{{0, 0}, {-1, 2}, {-2, 1}}, {}}}},
       polygon({{-3, 0}, {-3, -2}, {3, -2}, {3, 0}}),
       {{"edge under the touching point", {0, 0}, Contact::weak, false},
        {"a little higher", {0, Rational(1, 7)}, Contact::crossing, true},
        {"edge under the touching point, from above", {0, 2}, Contact::weak, true}}},
      {"hole that touches the outer chain",
       Region{{{box(0, 0, 4, 4), {backwards({{2, 0}, {3, 1}, {2, 2}, {1, 1}})}}}},
       diamond,
       {{"hole filled exactly", {2, 1}, Contact::opposite, false},
        {"outside, at the touching point", {2, -1}, Contact::weak, false},
        {"around the touching point", {2, 0}, Contact::crossing, true},
        {"in the region, on the hole's tip", {2, 3}, Contact::weak, true}}},
      {"the empty region",
       square,
       Region{},
       {{"anywhere", {0, 0}, Contact::none, false}, {"inside", {2, 2}, Contact::none, false}}},
      {"twice the empty region", Region{}, Region{}, {{"anywhere", {0, 0}, Contact::none, false}}},
  };
}

std::string where(const Pair& pair, const Placement& placement) {
  return pair.name + ": " + placement.name;
}

bool is_valid(const Region& region) {
  const auto encloses = [](int orientation) {
    return [=](const Chain& chain) { return sign(twice_area(chain)) == orientation; };
  };
  return !find_defect(region) &&
         std::all_of(region.components.begin(), region.components.end(), [&](const Component& c) {
           return encloses(1)(c.outer) && std::all_of(c.holes.begin(), c.holes.end(), encloses(-1));
         });
}

TEST(NamedPlacements, are_what_their_names_say) {
  for (const Pair& pair : pairs()) {
    ASSERT_TRUE(is_valid(pair.a) && is_valid(pair.b)) << pair.name;
    for (const Placement& placement : pair.placements) {
      const Region b = translated(pair.b, placement.x);
      EXPECT_EQ(strongest_contact(pair.a, b), placement.contact)
          << where(pair, placement) << ": " << describe(strongest_contact(pair.a, b));
      EXPECT_EQ(interiors_meet(pair.a, b), placement.meet) << where(pair, placement);
    }
  }
}

TEST(NamedPlacements, are_decided_by_every_method_either_way_round) {
  for (const CollisionMethod method : collision_methods) {
    for (const Pair& pair : pairs()) {
      const auto test = collision_test(method, pair.a, reflected(pair.b));
      const auto exchanged = collision_test(method, pair.b, reflected(pair.a));
      for (const Placement& placement : pair.placements) {
        EXPECT_EQ(test->interiors_meet_at(placement.x), placement.meet)
            << where(pair, placement) << ", by " << name_of(method);
        EXPECT_EQ(exchanged->interiors_meet_at(-placement.x), placement.meet)
            << where(pair, placement) << ", exchanged, by " << name_of(method);
      }
    }
  }
}

/// Shears and scales, so that nothing is horizontal, vertical or an integer.
const LinearMap slanted{Rational(1, 3), Rational(1, 7), Rational(-1, 13), Rational(1, 11)};

TEST(NamedPlacements, are_decided_by_every_method_where_no_coordinate_is_a_double) {
  for (const CollisionMethod method : collision_methods) {
    for (const Pair& pair : pairs()) {
      const auto test =
          collision_test(method, image(slanted, pair.a), reflected(image(slanted, pair.b)));
      for (const Placement& placement : pair.placements) {
        EXPECT_EQ(test->interiors_meet_at(slanted(placement.x)), placement.meet)
            << where(pair, placement) << ", by " << name_of(method);
      }
    }
  }
}

}  // namespace
}  // namespace oplus
