// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/certificate.hpp"

#include <gtest/gtest.h>

#include "checked/engines/engines.hpp"
#include "properties/compare/corpus.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/families/family.hpp"
#include "tests/checked/certificates/defect.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::certificates {
namespace {

Region sum_of(const Region& p, const Region& q) {
  return region_of(engines().front().compute(p, q, Boundary::closed, {}).sum);
}

std::string defect(const Region& p, const Region& q) {
  const Region s = sum_of(p, q);
  return Defect(p, q, s, certificate(p, q, s)).text();
}

TEST(Certificate, holds_for_all_pairs_of_shapes) {
  for (const Shape& p : shapes())
    for (const Shape& q : shapes())
      EXPECT_EQ(defect(p.region, q.region), "") << p.name << ", " << q.name;
}

TEST(Certificate, holds_for_all_families) {
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const auto [p, q] = generate(family, family.smallest + seed, seed);
      EXPECT_EQ(defect(p, q), "") << family.name << " " << seed;
    }
  }
}

TEST(Certificate, holds_for_the_corpus) {
  for (const CorpusPair& row : corpus()) {
    if (vertex_count(row.p) * vertex_count(row.q) < 500) {
      EXPECT_EQ(defect(row.p, row.q), "") << row.name;
    }
  }
}

TEST(Certificate, of_empty_regions) {
  const Region square = polygon(box(0, 0, 1, 1));
  EXPECT_EQ(defect({}, square), "");
  EXPECT_EQ(defect(square, {}), "");
  EXPECT_EQ(written(certificate({}, {}, {})),
            "oplus certificate 1\nunit 1\nsummand p\npoints 0\npieces 0\nlinks 0\n"
            "summand q\npoints 0\npieces 0\nlinks 0\nsum\npoints 0\npieces 0\nend\n");
}

/// Doubles can hold none of these, and only the middle of them without a shift.
TEST(Certificate, holds_for_coordinates_of_any_size) {
  const auto [p, q] = generate(*find_family("star"), 8, 1);
  for (const char* factor : {"1/97", "1000000000000000000000007", "1e400", "1e-400"}) {
    const std::string text = factor;
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, 400);
    const Rational by = text == "1e400"    ? Rational(power)
                        : text == "1e-400" ? 1 / Rational(power)
                                           : Rational(text);
    const auto scaled = [&](const Point& v) { return Point{by * v.x, by * v.y}; };
    EXPECT_EQ(defect(mapped(p, scaled), mapped(q, scaled)), "") << factor;
  }
}

/// verify accepts such a sum.
TEST(Certificate, holds_for_a_chain_that_touches_itself) {
  const Region p = together({polygon(box(0, 0, 1, 1)), polygon(box(2, 2, 3, 3))});
  const Region q = polygon(box(0, 0, 1, 1));
  const Region s = polygon({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}});
  EXPECT_EQ(Defect(p, q, s, certificate(p, q, s)).text(), "");
}

TEST(Certificate, is_written_line_by_line) {
  const Region p = polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const Region q = polygon(box(0, 0, Rational(1, 2), Rational(1, 2)));
  Certificate made = certificate(p, q, sum_of(p, q));
  EXPECT_EQ(made.unit, 2);
  made.p.pieces.pieces = {{0, 1, 2, 3}, {3, 4, 5, 0}};
  made.q.pieces.pieces = {{0, 1, 2, 3}};
  made.sum.points = {{4, {Rational(7, 2), 3}}};
  made.sum.pieces = {{0, 1, 2}};
  made.trees = {{IntegerLine{3, -4, 17}, PieceSums::Pair{0, 0}, PieceSums::Pair{1, 0}}};
  EXPECT_EQ(written(made),
            "oplus certificate 1\n"
            "unit 2\n"
            "summand p\npoints 0\npieces 2\n0 1 2 3\n3 4 5 0\nlinks 1\n0 1\n"
            "summand q\npoints 0\npieces 1\n0 1 2 3\nlinks 0\n"
            "sum\npoints 1\n4 7/2 3\npieces 1\n0 1 2\ncut 3 -4 17\nin 0 0\nin 1 0\n"
            "end\n");
}

TEST(Certificate, unit_of_unlike_denominators_is_a_power_of_two) {
  const auto unit_of = [](const Chain& chain) {
    const Region p = polygon(chain), q = polygon(box(0, 0, 1, 1));
    return certificate(p, q, sum_of(p, q)).unit;
  };
  EXPECT_EQ(unit_of({{0, 0}, {1, 0}, {Rational(1, 6), Rational(3, 4)}}), 12);
  const mpz_class large("1000000000000000000000007");
  EXPECT_EQ(unit_of({{0, 0}, {1, 0}, {0, 1 / Rational(large)}}), mpz_class(1) << 51);
}

TEST(Certificate, what_is_no_part_of_the_sum_has_none) {
  const Region p = holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)}), q = polygon(box(0, 0, 1, 1));
  EXPECT_THROW(certificate(p, q, polygon(box(0, 0, 5, 5))), PointOutsideSum);
}

/// So that tests can fail: S without a hole's part, a wrong pair, a missing link, another corner.
TEST(Certificate, defects_are_found) {
  const Region p = holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)}), q = polygon(box(0, 0, 1, 1));
  const Region s = sum_of(p, q);
  const Certificate made = certificate(p, q, s);
  ASSERT_EQ(Defect(p, q, s, made).text(), "");
  const auto with = [&](auto change) {
    Certificate changed = made;
    change(changed);
    return Defect(p, q, s, changed).text();
  };
  EXPECT_EQ(with([](Certificate& c) {
              for (Step& step : c.trees[0])
                if (auto* pair = std::get_if<PieceSums::Pair>(&step)) pair->i = (pair->i + 2) % 4;
            }),
            "a cell is not in its sum of pieces");
  EXPECT_EQ(with([](Certificate& c) { c.trees[0].clear(); }), "a tree ends early");
  EXPECT_EQ(with([](Certificate& c) { c.p.links.front().reached = 3; }),
            "a link from a piece that is not reached");
  EXPECT_EQ(with([](Certificate& c) { c.p.pieces.pieces.pop_back(); }),
            "the pieces of p have other edges than it");
  EXPECT_EQ(with([](Certificate& c) { std::ranges::reverse(c.sum.pieces[0]); }),
            "a piece of s has no fan");
  const Region part = polygon(box(0, 0, 5, 1));
  EXPECT_EQ(Defect(p, q, part, certificate(p, q, part)).text(),
            "an edge of S meets a sum of pieces");
}

/// 55 and 45 pieces, whose sums have 25,000 sides.
TEST(Certificate, of_two_stars_has_few_cells) {
  const Region p = generate(*find_family("star"), 100, 1).p;
  const Region q = generate(*find_family("star"), 100, 2).q;
  const Certificate made = certificate(p, q, sum_of(p, q));
  std::size_t cells = 0;
  for (const Tree& tree : made.trees)
    cells += static_cast<std::size_t>(std::ranges::count_if(
        tree, [](const Step& step) { return std::holds_alternative<PieceSums::Pair>(step); }));
  EXPECT_LT(cells, 600U);
}

}  // namespace
}  // namespace oplus::certificates
