// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/slide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

#include "checked/arrangement/rca.hpp"
#include "properties/compare/corpus.hpp"
#include "reference/chains/validity.hpp"
#include "reference/families/family.hpp"
#include "reference/families/polygons.hpp"
#include "reference/io/boundary_name.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

using slide::power_of_two;
using slide::quarter_turns;

constexpr Boundary both[] = {Boundary::closed, Boundary::open};

/// The stage that decided about pairs of edges, and none other did.
std::string stage(const Statistics& statistics) {
  std::string stages;
  if (statistics.count("in integers of 64 bits") > 0) stages += "64";
  if (statistics.count("in integers of 128 bits") > 0) stages += "128";
  if (statistics.count("in integers of GMP") > 0) stages += "gmp";
  if (statistics.count("in rationals") > 0) stages += "rationals";
  return stages;
}

std::string stage(const Region& p, const Region& q) {
  return stage(slide_sum(p, q, Boundary::closed).statistics);
}

void expect_as_rca(const Region& p, const Region& q, const std::string& what) {
  ASSERT_FALSE(find_defect(p)) << what;
  ASSERT_FALSE(find_defect(q)) << what;
  for (const Boundary boundary : both) {
    const ComputedSum expected = rca(p, q, boundary, {.with_origins = true});
    const ComputedSum result = slide_sum(p, q, boundary, {.with_origins = true});
    EXPECT_EQ(result.sum, expected.sum) << what << ", " << name(boundary);
    EXPECT_EQ(result.origins, expected.origins) << what << ", " << name(boundary);
  }
}

const Region triangle = polygon({{0, 0}, {2, 0}, {0, 2}});

/// A triangle with coordinates 0 and c.
Region triangle_to(const Rational& c) { return polygon({{0, 0}, {c, 0}, {0, c}}); }

/// A square with coordinates -c and c.
Region square_around_origin(const Rational& c) { return polygon(box(-c, -c, c, c)); }

TEST(Slide, slides_along_the_reduced_convolution) {
  for (const CorpusPair& row : corpus())
    EXPECT_EQ(slide_sum(row.p, row.q, Boundary::closed).statistics.count("segments slid along"),
              reduced_convolution(row.p, row.q).size())
        << row.name;
}

TEST(Slide, does_nothing_for_an_empty_summand) {
  for (const auto& [what, number] : slide_sum(triangle, Region(), Boundary::open).statistics)
    EXPECT_EQ(std::get<std::size_t>(number), 0U) << what;
}

/// A square with n by n holes.
template <typename HoleAt>
Region perforated(int n, const HoleAt& hole_at) {
  Region plate = polygon(box(-10, -10, 10 * n, 10 * n));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      plate.components[0].holes.push_back(backwards(hole_at(Vector{10 * i, 10 * j})));
  return plate;
}

/// Bars above and below a passage of height 4, with teeth that reach into its sides.
Region passage(int teeth) {
  Chain low{{-3, -9}, {4 * teeth + 3, -9}, {4 * teeth + 3, -3}};
  for (int i = teeth; i-- > 0;) low.insert(low.end(), {{4 * i + 2, 0}, {4 * i, -3}});
  Chain high;
  for (const Point& v : low) high.push_back({4 * teeth - v.x, 4 - v.y});
  return {{{low, {}}, {high, {}}}};
}

/// n squares in a staircase, each of which touches the next one.
Region staircase(int n) {
  Region squares;
  for (int i = 0; i < n; ++i)
    squares.components.push_back({box(2 * i, 2 * i, 2 * i + 2, 2 * i + 2), {}});
  return squares;
}

/// n triangles that touch in the origin.
Region fan(int n) {
  Region triangles;
  for (int i = 0; i < n; ++i)
    triangles.components.push_back({{{0, 0}, {9, 4 * i - 8}, {9, 4 * i - 5}}, {}});
  return triangles;
}

/// A bar with n holes, each of which touches the next one and both sides.
Region chain_of_holes(int n) {
  Region bar = polygon(box(0, 0, 4 * n, 4));
  for (int i = 0; i < n; ++i)
    bar.components[0].holes.push_back({{4 * i, 2}, {4 * i + 2, 4}, {4 * i + 4, 2}, {4 * i + 2, 0}});
  return bar;
}

TEST(Slide, finds_where_one_just_fits_into_the_other) {
  const Region q = polygon({{0, 0}, {3, 0}, {4, 2}, {1, 4}});
  const Region square = polygon(box(0, 0, 4, 4));
  const Region pockets = perforated(
      3, [&](const Vector& at) { return translated(reflected(q), at).components[0].outer; });
  const Region slots =
      perforated(3, [&](const Vector& at) { return box(at.x, at.y, at.x + 7, at.y + 4); });
  EXPECT_EQ(slide_sum(pockets, q, Boundary::open).sum.isolated_vertices.size(), 9u);
  EXPECT_EQ(slide_sum(slots, square, Boundary::open).sum.dangling_edges.size(), 9u);
  EXPECT_EQ(slide_sum(passage(5), square, Boundary::open).sum.dangling_edges.size(), 1u);
  expect_as_rca(pockets, q, "pockets");
  expect_as_rca(slots, square, "slots");
  expect_as_rca(perforated(2, [](const Vector& at) { return box(at.x, at.y, at.x + 5, at.y + 5); }),
                square, "holes with room");
  expect_as_rca(passage(5), square, "a passage");
  expect_as_rca(passage(5), polygon(box(0, 0, 11, 4)), "a passage for what is long");
  expect_as_rca(staircase(5), staircase(4), "staircases");
  expect_as_rca(staircase(4), reflected(staircase(4)), "staircases the other way round");
  expect_as_rca(fan(5), fan(4), "fans");
  expect_as_rca(fan(4), reflected(fan(5)), "fans the other way round");
  expect_as_rca(chain_of_holes(3), chain_of_holes(2), "holes that touch");
  expect_as_rca(chain_of_holes(3), polygon(box(0, 0, 2, 2)), "holes that touch, and a square");
}

TEST(Slide, leaves_out_copies_of_segments_where_there_are_many) {
  constexpr std::size_t k = 24;  // places of the sum: 2 k - 1 on a diagonal
  const Region squares = staircase(k);
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const ComputedSum all = slide_sum(squares, squares, boundary, {.with_origins = true});
    const ComputedSum fewer = slide_sum(squares, squares, boundary);
    EXPECT_EQ(all.sum, fewer.sum);
    EXPECT_EQ(all.statistics.count("segments slid along"), 8 * k * k);
    EXPECT_EQ(fewer.statistics.count("segments slid along"), 8 * (2 * k - 1));
  }
}

TEST(SlideStages, are_the_first_that_hold_the_bits_of_a_coordinate) {
  const auto power = power_of_two;
  const auto tiny = [](int denominator) { return triangle_to(Rational(1, denominator)); };
  const Region of_20_bits = square_around_origin(power(20) - 1);
  struct Row {
    std::string name;
    Region p, q;
    std::size_t bits;
    std::string stage;
  };
  for (const Row& row : {
           Row{"29 bits", square_around_origin(power(29) - 1), triangle, 29, "64"},
           {"30 bits", square_around_origin(power(29)), triangle, 30, "128"},
           {"30 bits, exchanged", triangle, square_around_origin(power(29)), 30, "128"},
           {"30 bits, of which the middle of the box takes one", triangle_to(power(30) - 2),
            triangle, 29, "64"},
           {"31 bits, of which it takes one", triangle_to(power(30)), triangle, 30, "128"},
           {"61 bits", square_around_origin(power(61) - 1), triangle, 61, "128"},
           {"62 bits", square_around_origin(power(61)), triangle, 62, "gmp"},
           {"a common denominator of 2 bits", of_20_bits, tiny(3), 22, "64"},
           {"a common denominator of 9 bits", of_20_bits, tiny(511), 29, "64"},
           {"a common denominator of 10 bits", of_20_bits, tiny(513), 30, "128"},
       }) {
    const Statistics statistics = slide_sum(row.p, row.q, Boundary::closed).statistics;
    EXPECT_EQ(statistics.count("bits of a coordinate"), row.bits) << row.name;
    EXPECT_EQ(stage(statistics), row.stage) << row.name;
  }
}

TEST(SlideStages, of_what_is_small_but_far_from_the_origin_are_64_bits) {
  const Region square = polygon(box(0, 0, 3, 5));
  const PlanarSet sum = slide_sum(square, triangle, Boundary::closed).sum;
  for (const char* far :
       {"536870912", "1000000000000000000000000000000000000000", "-99999999999"}) {
    const Vector by{Rational(far), -Rational(far) - 7};
    const Vector other{Rational(far) / 3, 5};
    const ComputedSum moved =
        slide_sum(translated(square, by), translated(triangle, other), Boundary::closed);
    EXPECT_EQ(moved.sum.outer, (std::vector<Chain>{translated(sum.outer[0], by + other)}));
    EXPECT_EQ(stage(moved.statistics), "64");
    EXPECT_LE(moved.statistics.count("bits of a coordinate"), 4u + 2);
  }
}

TEST(SlideStages, rationals_are_taken_where_a_common_denominator_would_be_long) {
  Random random(18);
  mpz_class prime = mpz_class(1) << 31;
  const auto with_denominators = [&](Region region) {
    for (Point& v : region.components[0].outer)
      for (Rational* c : {&v.x, &v.y}) {
        mpz_nextprime(prime.get_mpz_t(), prime.get_mpz_t());
        *c += Rational(1, prime);
      }
    return region;
  };
  const Region star = with_denominators(star_polygon(random, 16));
  const Region other = with_denominators(star_polygon(random, 6));
  EXPECT_EQ(stage(star, other), "rationals");
  EXPECT_EQ(stage(star, triangle), "rationals");
  expect_as_rca(star, other, "unlike denominators");
  const Region twice{{star.components[0], translated(star, {3'000'000, 0}).components[0]}};
  expect_as_rca(twice, other, "of two components");
  expect_as_rca(star, reflected(star), "that fits itself");
}

TEST(SlideStages, that_are_asked_for_are_taken) {
  const auto with = [](SlideNumbers numbers) {
    return stage(slide_sum(triangle, triangle, Boundary::closed, {.numbers = numbers}).statistics);
  };
  EXPECT_EQ(with(SlideNumbers::as_needed), "64");
  EXPECT_EQ(with(SlideNumbers::at_least_128_bits), "128");
  EXPECT_EQ(with(SlideNumbers::gmp), "gmp");
  EXPECT_EQ(with(SlideNumbers::rationals), "rationals");
  const EngineOptions at_least{.numbers = SlideNumbers::at_least_128_bits};
  EXPECT_EQ(stage(slide_sum(triangle_to(power_of_two(200)), square_around_origin(1),
                            Boundary::closed, at_least)
                      .statistics),
            "gmp");
}

/// Regions that reach from -m to m in both coordinates, as long and as thin as integers allow.
std::vector<Shape> reaching_shapes(const Rational& m) {
  return {
      {"square", polygon(box(-m, -m, m, m))},
      {"half a square", polygon({{-m, -m}, {m, -m}, {m, m}})},
      {"needle", polygon({{-m, -m}, {m, m - 1}, {m, m}})},
      {"hourglass", polygon({{-m, -m}, {m, -m}, {1, 0}, {m, m}, {-m, m}, {-1, 0}})},
      {"narrow frame", {{{box(-m, -m, m, m), {backwards(box(1 - m, 1 - m, m - 1, m - 1))}}}}},
      {"two halves, and a diagonal slit between",
       {{{{{2 - m, -m}, {m, -m}, {m, m - 2}}, {}}, {{{-m, 2 - m}, {m - 2, m}, {-m, m}}, {}}}}},
  };
}

class AtTheLimit : public testing::TestWithParam<int> {};

TEST_P(AtTheLimit, of_a_stage_every_combination_of_signs_is_exact) {
  const Rational m = power_of_two(GetParam()) - 1;
  const std::vector<Shape> shapes = reaching_shapes(m);
  const std::string expected = GetParam() <= 29 ? "64" : GetParam() <= 61 ? "128" : "gmp";
  for (const Shape& p : shapes) {
    for (const Shape& q : shapes) {
      for (int times = 0; times < 4; ++times) {
        const Region of_q = image(quarter_turns(times), q.region);
        EXPECT_EQ(stage(p.region, of_q), expected);
        expect_as_rca(p.region, of_q, p.name + " and " + q.name + ", " + std::to_string(times));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bits, AtTheLimit, testing::Values(28, 29, 30, 60, 61, 62),
                         testing::PrintToStringParamName());

TEST(Slide, is_exact_where_exponents_of_doubles_are_mixed) {
  const Rational huge(1e300), tiny(1e-300);
  const Region wedge = polygon({{0, 0}, {huge, tiny}, {tiny, huge}, {tiny, tiny}});
  const Region needle = polygon({{-1e-300, 0.1}, {1e300, 1e-17}, {0.3, 1e17}});
  const Region frame{{{box(-huge, -huge, huge, huge), {backwards(box(-tiny, -tiny, tiny, tiny))}}}};
  const Region dot = polygon(box(0, 0, tiny, 2 * tiny));
  for (const Region* p : {&wedge, &needle, &frame, &dot}) {
    EXPECT_EQ(stage(*p, needle), "gmp");
    for (const Region* q : {&wedge, &needle, &frame, &dot}) expect_as_rca(*p, *q, "mixed");
  }
}

TEST(Slide, is_exact_where_one_summand_is_a_point_beside_the_other) {
  const Region star = generate(*find_family("star"), 300, 1).p;
  for (const Rational& far : {power_of_two(300), Rational(power_of_two(1500) / 3)}) {
    expect_as_rca(star, square_around_origin(far), "star and square");
    expect_as_rca(triangle_to(far), star, "triangle and star");
  }
}

TEST(Slide, is_exact_where_denominators_are_large_and_coprime) {
  const auto over = [](int n, const char* d) { return Rational(std::to_string(n) + "/" + d); };
  const char* const p1 = "1000000007";
  const char* const p2 = "998244353";
  const char* const p3 = "170141183460469231731687303715884105727";  // 2^127 - 1
  const Region dart = polygon({{over(1, p1), over(-5, p2)},
                               {3 + over(2, p2), over(1, p1)},
                               {over(1, "3"), over(2, "7")},
                               {over(-4, p1), 2 + over(11, p2)}});
  const Region thin = polygon({{0, over(1, p3)}, {1, over(2, p3)}, {1, over(3, p3)}});
  EXPECT_EQ(stage(dart, dart), "gmp");
  EXPECT_EQ(stage(dart, thin), "gmp");
  expect_as_rca(dart, dart, "dart and dart");
  expect_as_rca(dart, thin, "dart and needle");
  expect_as_rca(thin, thin, "needle and needle");
}

TEST(Slide, does_not_go_through_infinity) {
  const Rational huge = power_of_two(1200), tiny = power_of_two(-1200);
  const auto slotted = [&](const Rational& width) {
    return Region{{{box(-huge, -huge, huge, huge), {backwards(box(0, 0, huge / 2, width))}}}};
  };
  const Region dot = polygon(box(0, 0, tiny, tiny));
  EXPECT_EQ(slide_sum(slotted(tiny + tiny * tiny), dot, Boundary::closed).sum.holes,
            (std::vector<Chain>{{{tiny, tiny},
                                 {tiny, tiny + tiny * tiny},
                                 {huge / 2, tiny + tiny * tiny},
                                 {huge / 2, tiny}}}));
  EXPECT_EQ(slide_sum(slotted(tiny), dot, Boundary::open).sum.dangling_edges,
            (std::vector<Segment>{{{tiny, tiny}, {huge / 2, tiny}}}));
  EXPECT_TRUE(slide_sum(slotted(tiny), dot, Boundary::closed).sum.holes.empty());
  expect_as_rca(slotted(tiny / 2), dot, "closed slot");
}

TEST(Slide, says_how_many_segments_are_done) {
  const Summands pair = generate(*find_family("star"), 40, 3);
  for (const unsigned threads : {1U, 2U}) {
    std::mutex mutex;
    std::vector<std::size_t> seen;
    const ComputedSum result =
        slide_sum(pair.p, pair.q, Boundary::closed,
                  {.threads = threads, .progress = [&](std::size_t done, std::size_t total) {
                     const std::lock_guard lock(mutex);
                     seen.push_back(done);
                     EXPECT_LE(done, total);
                     EXPECT_EQ(total, reduced_convolution(pair.p, pair.q).size());
                   }});
    EXPECT_GT(seen.size(), 1U);
    EXPECT_EQ(*std::max_element(seen.begin(), seen.end()),
              result.statistics.count("segments slid along"));
  }
}

TEST(SlideNumbers, do_not_change_the_result) {
  for (const Family& family : families()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const auto [p, q] = generate(family, family.typical, seed);
      for (const Boundary boundary : both) {
        const auto with = [&, &p = p, &q = q](SlideNumbers numbers) {
          return slide_sum(p, q, boundary, {.with_origins = true, .numbers = numbers});
        };
        const ComputedSum needed = with(SlideNumbers::as_needed);
        for (const SlideNumbers larger :
             {SlideNumbers::at_least_128_bits, SlideNumbers::gmp, SlideNumbers::rationals}) {
          const ComputedSum result = with(larger);
          EXPECT_EQ(result.sum, needed.sum) << family.name << ' ' << seed;
          EXPECT_EQ(result.origins, needed.origins) << family.name << ' ' << seed;
          EXPECT_EQ(result.statistics.count("free pieces of segments"),
                    needed.statistics.count("free pieces of segments"));
        }
      }
    }
  }
}

TEST(SlideThreads, do_not_change_the_result) {
  Random random(7);
  const Region star = star_polygon(random, 120), other_star = star_polygon(random, 80);
  const Region large_star = star_polygon(random, 200);
  const auto [frames, islands] = generate(*find_family("islands"), 12, 3);
  const std::pair<Region, Region> pairs[] = {{star, other_star}, {frames, large_star}};
  for (const auto& [p, q] : pairs) {
    for (const Boundary boundary : both) {
      const auto with = [&, &p = p, &q = q](unsigned threads) {
        return slide_sum(p, q, boundary, {.with_origins = true, .threads = threads});
      };
      const ComputedSum one = with(1);
      ASSERT_GE(one.statistics.count("segments slid along"), 1024u)
          << "fewer are not worth a thread";
      for (const unsigned threads : {2u, 3u, 8u}) {
        const ComputedSum result = with(threads);
        EXPECT_EQ(result.sum, one.sum) << threads;
        EXPECT_EQ(result.origins, one.origins) << threads;
        EXPECT_TRUE(result.statistics == one.statistics) << threads;
      }
    }
  }
}

TEST(Slide, opens_few_boxes_in_spirals_and_among_many_components) {
  for (const auto& [family, n] : {std::pair("spiral", 1000u), std::pair("dots", 60u)}) {
    const auto [p, q] = generate(*find_family(family), n, 1);
    const Statistics found = slide_sum(p, q, Boundary::closed).statistics;
    EXPECT_LE(found.count("pairs of boxes"), 135 * found.count("segments slid along")) << family;
  }
}

}  // namespace
}  // namespace oplus
