// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/layouts/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "checked/layouts/reading.hpp"
#include "reference/chains/swept_cells.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/region.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/families/family.hpp"
#include "reference/io/reading.hpp"

namespace oplus {
namespace {

const Rational tiny("1/1000000000");

Region of(const std::string& wkt) { return read_region(wkt, "test").region; }

Sheet sheet_of(const std::string& parts, const std::string& container = "") {
  Sheet sheet = read_layout(parts, "test", "", tiny).sheets.at(0);
  if (!container.empty()) sheet.container = of(container);
  return sheet;
}

/// The area of what `is_in` says of the faces of the arrangement of two boundaries: by no sum, union or box.
template <typename IsIn>
Rational area_where(const Region& a, const Region& b, const IsIn& is_in) {
  std::vector<Segment> all = edges(a);
  for (const Segment& e : edges(b)) all.push_back(e);
  const Cells cells = swept_cells(all);
  Rational twice = 0;
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    if (f == cells.unbounded_face || !is_in(point_inside(cells.faces[f]))) continue;
    for (const Segment& e : cells.faces[f]) twice += cross(e.source, e.target);
  }
  return twice / 2;
}

Rational common_area(const Region& a, const Region& b) {
  return area_where(a, b, [&](const Point& x) {
    return locate(x, a) == Location::inside && locate(x, b) == Location::inside;
  });
}

Rational area_outside(const Region& part, const Region& container) {
  return area_where(part, container, [&](const Point& x) {
    return locate(x, part) == Location::inside && locate(x, container) == Location::outside;
  });
}

/// Requires: their interiors don't meet.
Rational squared_distance(const Region& a, const Region& b) {
  Rational least = -1;
  const auto see = [&](const Region& p, const Region& q) {
    for (const Segment& e : edges(p))
      for (const Segment& f : edges(q)) {
        const Rational here = intersection(e, f).empty() ? squared_distance(e.source, f) : 0;
        if (sgn(least) < 0 || here < least) least = here;
      }
  };
  see(a, b);
  see(b, a);
  return least;
}

Region placed(const PlacedPart& part) { return translated(*part.shape, part.at); }

/// What a fault says, by the definitions.
void expect_true(const Sheet& sheet, const LayoutRules& rules, const LayoutFault& fault) {
  const Region part = placed(sheet.parts.at(fault.part));
  const Region other = fault.other ? placed(sheet.parts.at(*fault.other)) : Region{};
  if (const auto* nearest = std::get_if<NearestPoints>(&fault.what)) {
    EXPECT_EQ(squared_length(nearest->on_p - nearest->on_q), nearest->squared_distance);
    EXPECT_NE(locate(nearest->on_q, part), Location::outside);
    const Rational& gap = fault.other ? rules.spacing : rules.margin;
    EXPECT_LT(nearest->squared_distance, gap * gap);
    if (fault.other) {
      EXPECT_NE(locate(nearest->on_p, other), Location::outside);
      EXPECT_EQ(nearest->squared_distance,
                interiors_meet(other, part) ? 0 : squared_distance(other, part));
    } else {
      EXPECT_NE(locate(nearest->on_p, *sheet.container), Location::inside);
    }
    return;
  }
  const auto& found = std::get<OverlapFound>(fault.what);
  EXPECT_EQ(locate(found.witness, part), Location::inside);
  const auto is_wrong_after = [&](const Vector& move) {
    const Region moved = translated(part, move);
    return fault.other ? interiors_meet(other, moved) : area_outside(moved, *sheet.container) > 0;
  };
  if (fault.other) {
    EXPECT_EQ(locate(found.witness, other), Location::inside);
    EXPECT_EQ(found.area, common_area(other, part));
    ASSERT_TRUE(found.way_out);
  } else {
    EXPECT_EQ(locate(found.witness, *sheet.container), Location::outside);
    EXPECT_EQ(found.area, area_outside(part, *sheet.container));
  }
  if (!found.way_out) return;
  const Vector& move = found.way_out->move;
  EXPECT_EQ(squared_length(move), found.way_out->squared_depth);
  EXPECT_GT(found.way_out->squared_depth, rules.tolerance * rules.tolerance);
  EXPECT_FALSE(is_wrong_after(move));
  EXPECT_TRUE(is_wrong_after(Rational(999, 1000) * move));
}

struct Case {
  std::string name, parts, container;
  LayoutRules rules;
  std::size_t faults, forgiven = 0;
};

TEST(CheckOfALayout, decides_layouts_made_on_purpose) {
  const std::string square = "POLYGON((0 0,2 0,2 2,0 2,0 0))\n";
  const std::string frame = "POLYGON((0 0,9 0,9 9,0 9,0 0),(3 3,3 6,6 6,6 3,3 3))\n";
  const Case cases[] = {
      {"contact along an edge", square + "POLYGON((2 0,4 0,4 2,2 2,2 0))", "", {}, 0},
      {"contact in a corner", square + "POLYGON((2 2,4 2,4 4,2 4,2 2))", "", {}, 0},
      {"overlap by 1e-9", square + "POLYGON((1.999999999 0,4 0,4 2,2 2,1.999999999 0))", "", {}, 1},
      {"as deep as forgiven",
       square + "POLYGON((1.999999999 0,4 0,4 2,1.999999999 2,1.999999999 0))",
       "",
       {0, 0, tiny},
       0,
       1},
      {"deeper",
       square + "POLYGON((1.999999999 0,4 0,4 2,1.999999999 2,1.999999999 0))",
       "",
       {0, 0, tiny - tiny * tiny},
       1},
      {"equal", square + square, "", {}, 1},
      {"exactly in the container", square, square, {}, 0},
      {"outside by 1e-9", "POLYGON((0 0,2.000000001 0,2 2,0 2,0 0))", square, {}, 1},
      {"outside by what is forgiven",
       "POLYGON((1e-9 0,2.000000001 0,2.000000001 2,1e-9 2,1e-9 0))",
       square,
       {0, 0, tiny},
       0,
       1},
      {"far outside", "POLYGON((100 100,101 100,101 101,100 101,100 100))", square, {}, 1},
      {"over a hole of the container", "POLYGON((1 4,8 4,8 5,1 5,1 4))", frame, {}, 1},
      {"in a hole of the container", "POLYGON((4 4,5 4,5 5,4 5,4 4))", frame, {}, 1},
      {"through a hole of a part", frame + "POLYGON((1 4,8 4,8 5,1 5,1 4))", "", {}, 1},
      {"in a hole of a part", frame + "POLYGON((3 3,6 3,6 6,3 6,3 3))", "", {}, 0},
      {"spacing met", square + "POLYGON((3 0,4 0,4 2,3 2,3 0))", "", {1, 0, 0}, 0},
      {"spacing missed by 1e-12",
       square + "POLYGON((2.999999999999 0,4 0,4 2,3 2,2.999999999999 0))",
       "",
       {1, 0, 0},
       1},
      {"spacing in a hole", frame + "POLYGON((4 4,5 4,5 5,4 5,4 4))", "", {1, 0, 0}, 0},
      {"margin met", "POLYGON((1 1,2 1,2 2,1 2,1 1))", frame, {0, 1, 0}, 0},
      {"margin missed by 1e-12",
       "POLYGON((1 0.999999999999,2 1,2 2,1 2,1 0.999999999999))",
       frame,
       {0, 1, 0},
       1},
      {"forgiven is not apart", square + square, "", {1, 0, 2}, 1, 1},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Sheet sheet = sheet_of(c.parts, c.container);
    const SheetVerdict verdict = check(sheet, c.rules, 2);
    EXPECT_EQ(verdict.faults.size(), c.faults);
    EXPECT_EQ(verdict.forgiven, c.forgiven);
    for (const LayoutFault& fault : verdict.faults) expect_true(sheet, c.rules, fault);
  }
}

TEST(CheckOfALayout, says_where_a_part_fits_nowhere) {
  const Sheet sheet = sheet_of("POLYGON((0 0,3 0,3 1,0 1,0 0))", "POLYGON((0 0,2 0,2 2,0 2,0 0))");
  const SheetVerdict verdict = check(sheet, {}, 1);
  ASSERT_EQ(verdict.faults.size(), 1U);
  EXPECT_FALSE(std::get<OverlapFound>(verdict.faults[0].what).way_out);
  EXPECT_EQ(verdict.used_area, 3);
  EXPECT_EQ(verdict.area, 4);
}

TEST(CheckOfALayout, lets_parts_lie_on_defects_that_are_good_enough) {
  Sheet sheet = sheet_of("POLYGON((1 1,2 1,2 2,1 2,1 1))", "POLYGON((0 0,9 0,9 9,0 9,0 0))");
  sheet.defects.push_back({of("POLYGON((-1 -1,5 -1,5 5,-1 5,-1 -1))"), 2});
  EXPECT_EQ(check(sheet, {}, 1).faults.size(), 1U);
  EXPECT_EQ(check(sheet, {}, 1).area, 81 - 25);
  for (const auto& [least, faults] : {std::pair(3, 1U), std::pair(2, 0U), std::pair(1, 0U)}) {
    sheet.parts[0].least_quality = least;
    EXPECT_EQ(check(sheet, {}, 1).faults.size(), faults) << least;
  }
}

/// Small regions near each other, so that many pairs touch, overlap, or just keep their distance.
TEST(CheckOfALayout, agrees_with_the_definition_on_random_layouts) {
  Random random(20261126);
  std::size_t overlaps = 0, contacts = 0, too_near = 0, outside = 0, inside = 0, right = 0;
  for (int layout = 0; layout < 1000; ++layout) {
    SCOPED_TRACE(layout);
    const auto region = [&](std::size_t size) {
      const char* name = one_in(random, 8) ? "islands" : "grid";
      const std::uint64_t seed = random();
      return generate(*find_family(name), size, seed).p;
    };
    Sheet sheet;
    if (one_in(random, 2))
      sheet.container = mapped(region(6), [](const Point& x) { return Rational(2) * x; });
    const int count = uniform(random, 2, 4);
    for (int i = 0; i < count; ++i) {
      const int x = uniform(random, 0, 8);
      const int y = uniform(random, 0, 8);
      sheet.parts.push_back({"", 0, std::make_shared<const Region>(region(4)), {x, y}, {}});
    }
    const LayoutRules rules{uniform(random, 0, 1), 0, Rational(uniform(random, 0, 3), 4)};
    const SheetVerdict verdict = check(sheet, rules, 1);
    const auto reported = [&](std::optional<std::size_t> other, std::size_t part) {
      return std::any_of(verdict.faults.begin(), verdict.faults.end(),
                         [&](const LayoutFault& f) { return f.other == other && f.part == part; });
    };
    std::size_t unreported = 0;  // and so forgiven
    for (std::size_t j = 0; j < sheet.parts.size(); ++j) {
      const Region q = placed(sheet.parts[j]);
      for (std::size_t i = 0; i < j; ++i) {
        const Region p = placed(sheet.parts[i]);
        const bool meet = interiors_meet(p, q);
        const Rational squared = meet ? 0 : squared_distance(p, q);
        const bool near = squared < rules.spacing * rules.spacing;
        overlaps += meet ? 1 : 0;
        contacts += !meet && squared == 0 ? 1 : 0;
        too_near += near && squared > 0 ? 1 : 0;
        unreported += meet && !reported(i, j) ? 1 : 0;
        EXPECT_TRUE(meet || reported(i, j) == near);
      }
      if (!sheet.container) continue;
      const bool leaves = area_outside(q, *sheet.container) > 0;
      (leaves ? outside : inside) += 1;
      unreported += leaves && !reported(std::nullopt, j) ? 1 : 0;
      EXPECT_TRUE(leaves || !reported(std::nullopt, j));
    }
    // With a spacing, those that are forgiven are too near.
    EXPECT_TRUE(rules.spacing > 0 ? unreported <= verdict.forgiven
                                  : unreported == verdict.forgiven);
    EXPECT_TRUE(unreported == 0 || rules.tolerance > 0);
    for (const LayoutFault& fault : verdict.faults) expect_true(sheet, rules, fault);
    right += verdict.is_right() ? 1 : 0;
  }
  for (const std::size_t seen : {overlaps, contacts, outside, right}) EXPECT_GT(seen, 100U);
  for (const std::size_t seen : {too_near, inside}) EXPECT_GT(seen, 20U);
}

TEST(CheckOfALayout, of_a_part_that_is_placed_twice_and_of_defects_without_a_container) {
  Sheet sheet = sheet_of(
      R"~({"parts": {"a": [[0,0],[2,0],[2,1],[0,1]]}, "placements": [{"part": "a"}, {"part": "a", "at": [2, 0]}]})~");
  EXPECT_TRUE(check(sheet, {}, 1).is_right());
  sheet.defects.push_back({of("POLYGON((3 0,4 0,4 1,3 0))")});
  EXPECT_EQ(check(sheet, {}, 1).faults.size(), 1U);
}

/// Doubles decide no contact there.
TEST(CheckOfALayout, is_exact_without_a_short_common_denominator) {
  const std::string t = "1/1000000000000000003", beyond = "8000000000000000025/2000000000000000006";
  const auto faults = [](const Sheet& sheet) { return check(sheet, {}, 1).faults.size(); };
  const std::string left = "POLYGON((0 0,2 0,2 1,0 1,0 0))\n";
  const Sheet sheet =
      sheet_of(left + "POLYGON((2 0,4 0,4 1,2 1,2 0))", "POLYGON((0 0,9 0,9 9,0 9,0 0))");
  for (const std::size_t part : {0U, 1U}) {
    Sheet moved = sheet;
    moved.parts[part].at.x += Rational(t);
    EXPECT_EQ(faults(moved), 1 - part);
  }
  EXPECT_EQ(faults(sheet_of(left + "POLYGON((2 0,4 0,4 " + t + ",2 1,2 0))")), 0U);
  for (const auto& [low, expected] : {std::pair("-" + t, 0U), {t, 1U}}) {
    Sheet other = sheet;
    other.container = of("POLYGON((" + low + " 0,9 0,9 9," + low + " 9," + low + " 0))");
    EXPECT_EQ(faults(other), expected);
  }
  for (const auto& [low, expected] : {std::pair(beyond, 0U), {"3", 1U}}) {
    Sheet other = sheet;
    other.defects.push_back(
        {of("POLYGON((" + low + " 0,5 0,5 " + t + "," + low + " 1," + low + " 0))")});
    EXPECT_EQ(faults(other), expected);
  }
}

}  // namespace
}  // namespace oplus
