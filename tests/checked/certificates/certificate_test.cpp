// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/certificate.hpp"

#include <gtest/gtest.h>

#include "checked/engines/engines.hpp"
#include "properties/compare/certified_engine.hpp"
#include "properties/compare/corpus.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/families/family.hpp"
#include "reference/io/invalid_input.hpp"
#include "tests/reference/definitions/shapes.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus::certificates {
namespace {

Region sum_of(const Region& p, const Region& q) {
  return region_of(engines().front().compute(p, q, Boundary::closed, {}).sum);
}

/// The program that is proved right accepts a sum with the certificate that is made for it.
/// tests/properties/proofs/certified_sums_test.cpp asks it about sums of all families, and about damaged ones.
void expect_certified(const Region& p, const Region& q, const Region& s, const std::string& what) {
  const EndedProcess ended = checked_certificate("sum", p, q, {s, {}, {}},
                                                 written(certificate(p, q, s)), {.is_quiet = true});
  EXPECT_TRUE(says_certified(ended)) << what << ": " << ended.output << ended.errors;
}

TEST(Certificate, holds_for_the_corpus) {
  for (const CorpusPair& row : corpus()) {
    if (vertex_count(row.p) * vertex_count(row.q) < 500)
      expect_certified(row.p, row.q, sum_of(row.p, row.q), row.name);
  }
}

TEST(Certificate, of_empty_regions) {
  const Region square = polygon(box(0, 0, 1, 1));
  expect_certified({}, square, {}, "P is empty");
  expect_certified(square, {}, {}, "Q is empty");
  EXPECT_EQ(written(certificate({}, {}, {})),
            "oplus certificate 2\nclaim sum\nunit 1\nsummand p\npoints 0\npieces 0\nlinks 0\n"
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
    const Region of_p = mapped(p, scaled), of_q = mapped(q, scaled);
    expect_certified(of_p, of_q, sum_of(of_p, of_q), factor);
  }
}

/// In doubles the smaller one is a point.
TEST(Certificate, holds_for_sizes_that_differ_by_more_than_doubles) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, 324);
  const Rational large(power);
  const Region p = polygon({{0, 0}, {large, 0}, {0, large}});
  const Region q = polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const auto smaller = [&](const Point& v) { return Point{v.x / large, v.y / large}; };
  const Region s = sum_of(p, q);
  expect_certified(p, q, s, "Q is small");
  expect_certified(q, p, s, "P is small");
  expect_certified(mapped(p, smaller), mapped(q, smaller), mapped(s, smaller), "both are");
}

/// verify accepts such a sum.
TEST(Certificate, holds_for_a_chain_that_touches_itself) {
  const Region p = together({polygon(box(0, 0, 1, 1)), polygon(box(2, 2, 3, 3))});
  const Region q = polygon(box(0, 0, 1, 1));
  const Region s = polygon({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}});
  expect_certified(p, q, s, "it touches itself");
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
  made.trees = {{Cut{{3, -4, 17}, {}}, PieceSums::Pair{0, 0}, PieceSums::Pair{1, 0}}};
  EXPECT_EQ(written(made),
            "oplus certificate 2\n"
            "claim sum\n"
            "unit 2\n"
            "summand p\npoints 0\npieces 2\n0 1 2 3\n3 4 5 0\nlinks 1\n0 1\n"
            "summand q\npoints 0\npieces 1\n0 1 2 3\nlinks 0\n"
            "sum\npoints 1\n4 7/2 3\npieces 1\n0 1 2\ncut 3 -4 17\nin 0 0\nin 1 0\n"
            "end\n");
}

/// oplus-certified would refuse to read it.
TEST(Certificate, none_is_written_that_is_larger_than_is_read) {
  const auto refusal_of = [](const Certificate& certificate) {
    return refusal([&] { written(certificate); });
  };
  const auto of_tree = [](std::size_t cuts) {
    Certificate made;
    made.sum.pieces = {{0, 1, 2}};
    made.trees = {Tree(cuts, Cut{{1, 0, 0}, {}})};
    made.trees[0].insert(made.trees[0].end(), cuts + 1, PieceSums::Pair{0, 0});
    return made;
  };
  EXPECT_EQ(refusal_of(of_tree(100'000)), "accepted");
  EXPECT_EQ(
      refusal_of(of_tree(100'001)),
      "the certificate: a tree of 100001 cuts above one another; expected at most 100000, the "
      "limit of oplus-certified");
  Certificate made;
  mpz_ui_pow_ui(made.unit.get_mpz_t(), 10, 99'999);
  EXPECT_EQ(refusal_of(made), "accepted");
  made.unit *= 10;
  EXPECT_EQ(refusal_of(made),
            "the certificate: a number of 100001 characters; expected at most 100000, the limit of "
            "oplus-certified");
  made.unit = 1;
  constexpr std::uint32_t large = ~std::uint32_t{0};
  made.p.links.assign((std::size_t{1} << 27) / 22 + 1, {large, large});
  EXPECT_EQ(refusal_of(made),
            "the certificate: a text of more bytes; expected at most 134217728, the limit of "
            "oplus-certified");
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

std::size_t cells(const Region& p, const Region& q) {
  std::size_t count = 0;
  for (const Tree& tree : certificate(p, q, sum_of(p, q)).trees)
    count += static_cast<std::size_t>(std::ranges::count_if(
        tree, [](const Step& step) { return std::holds_alternative<PieceSums::Pair>(step); }));
  return count;
}

/// 54 and 45 pieces; the sum has 178.
TEST(Certificate, of_two_stars_has_few_cells) {
  const Family& star = *find_family("star");
  EXPECT_LT(cells(generate(star, 100, 1).p, generate(star, 100, 2).q), 600U);
}

/// Q is larger than the passage between the arms of P, so the sum is one piece, which hundreds of long sums
/// of pieces cover; cuts that went on across others would make thousands of cells.
TEST(Certificate, of_a_filled_spiral_has_few_cells) {
  const Region p = generate(*find_family("spiral"), 300, 1).p;
  EXPECT_LT(cells(p, polygon(box(0, 0, 5, 5))), 1200U);
}

/// Vertices on a line but one, or nearly on a line: of thousands of pairs of long pieces, each cell is in many.
TEST(Certificate, holds_for_long_pieces_that_cross) {
  Chain line, curve;
  for (int x = 0; x < 400; ++x) {
    line.push_back({x, 0});
    curve.push_back({x, x * x});
  }
  line.push_back({200, 1});
  for (const Chain& chain : {line, curve}) {
    const Region p = polygon(chain);
    const Region s = sum_of(p, p);
    expect_certified(p, p, s, "long pieces");
    EXPECT_LT(cells(p, p), 200U);
  }
}

}  // namespace
}  // namespace oplus::certificates
