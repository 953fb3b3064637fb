// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/arithmetic/interval.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "reference/families/random.hpp"

namespace oplus {
namespace {

const Rational huge("1" + std::string(400, '0'));
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least = std::numeric_limits<double>::denorm_min();

bool contains(const Interval& interval, const Rational& value) {
  return (interval.low == -infinity || Rational(interval.low) <= value) &&
         (interval.high == infinity || Rational(interval.high) >= value);
}

TEST(Interval, of_a_double_is_exact) {
  for (const double value :
       {0., 0.75, -0.1, 3e300, DBL_MAX, -DBL_MAX, DBL_MIN, least, -3 * least}) {
    const Interval around = interval(Rational(value));
    EXPECT_EQ(around.low, value);
    EXPECT_EQ(around.high, value);
  }
}

TEST(Interval, of_another_number_is_around_it) {
  const Rational beyond = Rational(DBL_MAX) + 1;
  for (const Rational& value :
       {Rational(1, 3), Rational(-2, 7), Rational(1 / huge), Rational(-1 / huge), beyond,
        Rational(-beyond), huge, Rational(-huge), Rational(Rational(1) + 1 / huge),
        Rational(Rational(least) / 2), Rational(Rational(least) * 5 / 2),
        Rational((mpz_class(1) << 53) + 1), Rational(-(mpz_class(1) << 53) - 1),
        Rational((mpz_class(1) << 63) - 1), Rational((mpz_class(1) << 64) + 1)}) {
    const Interval around = interval(value);
    EXPECT_TRUE(contains(around, value)) << value;
    EXPECT_LT(around.low, around.high) << value;
    if (abs(value) < beyond) {
      EXPECT_LE(around.high - around.low, std::abs(around.low) * 0x1p-50 + 3 * least) << value;
    }
  }
}

/// Doubles of every kind: small integers, few bits, many bits, subnormal, near overflow.
double draw_double(Random& random) {
  const auto bits = [&](int count) {
    return static_cast<double>(random() >> (64 - count)) * (random() % 2 == 0 ? 1 : -1);
  };
  switch (random() % 8) {
    case 0:
      return uniform(random, -3, 3);
    case 1:
      return bits(26);
    case 2:
      return bits(53);
    case 3:
      return std::ldexp(bits(20), uniform(random, -1074, -1000));
    case 4:
      return std::ldexp(bits(20), uniform(random, -560, -480));  // products underflow
    case 5:
      return std::ldexp(bits(53), uniform(random, 450, 470));  // products overflow
    case 6:
      return std::ldexp(bits(53), 971);  // sums overflow
    default:
      return std::ldexp(bits(53), uniform(random, -80, 20));
  }
}

/// Exact numbers, neighbours, and wide intervals; also unbounded ones.
Interval draw_interval(Random& random, const Interval& before) {
  const double a = draw_double(random);
  switch (random() % 6) {
    case 0:
      return {a, std::nextafter(a, infinity)};
    case 1: {
      const double b = draw_double(random);
      return {std::min(a, b), std::max(a, b)};
    }
    case 2:
      return std::isinf(before.low + before.high) ? Interval{a, a}  // cancels all, or nearly
                                                  : Interval{-before.high, -before.low};
    case 3:
      return random() % 2 == 0 ? Interval{a, infinity} : Interval{-infinity, a};
    default:
      return {a, a};
  }
}

/// Numbers of an interval: its ends and one between, or large ones where it is unbounded.
std::vector<Rational> numbers_of(const Interval& of) {
  const Rational low = std::isinf(of.low) ? Rational(-huge) : Rational(of.low);
  const Rational high = std::isinf(of.high) ? huge : Rational(of.high);
  return {low, high, Rational((2 * low + high) / 3)};
}

TEST(Interval, arithmetic_contains_the_exact_results) {
  Random random(7);
  std::map<std::string, int> seen;
  for (int i = 0; i < 40000; ++i) {
    const Interval a = draw_interval(random, {1, 2});
    const Interval b = draw_interval(random, a);
    const bool is_division = b.low > 0 || b.high < 0;
    const std::vector<std::pair<std::string, Interval>> results{
        {"+", a + b}, {"-", a - b}, {"*", a * b}, {"/", a / b}};
    for (const auto& [operation, result] : results) {
      ASSERT_LE(result.low, result.high) << "an end is NaN";
      ++seen[operation + (is_exact(result)                                    ? " exact"
                          : std::isinf(result.low) || std::isinf(result.high) ? " unbounded"
                                                                              : " bounded")];
      if (operation == "/" && !is_division) {
        ASSERT_TRUE(std::isinf(result.low) && std::isinf(result.high));
        continue;
      }
      for (const Rational& x : numbers_of(a)) {
        for (const Rational& y : numbers_of(b)) {
          const Rational exact = operation == "+"   ? Rational(x + y)
                                 : operation == "-" ? Rational(x - y)
                                 : operation == "*" ? Rational(x * y)
                                                    : Rational(x / y);
          ASSERT_TRUE(contains(result, exact))
              << a.low << ' ' << a.high << ' ' << operation << ' ' << b.low << ' ' << b.high;
        }
      }
    }
  }
  for (const char* operation : {"+", "-", "*"})
    for (const char* kind : {" exact", " unbounded", " bounded"})
      EXPECT_GT(seen[std::string(operation) + kind], 1000) << operation << kind;
  EXPECT_GT(seen["/ bounded"], 1000);
  EXPECT_GT(seen["/ unbounded"], 1000);
}

TEST(Interval, signs_and_orders_are_those_of_all_numbers_inside) {
  EXPECT_EQ(sign(Interval{1, 2}), 1);
  EXPECT_EQ(sign(Interval{-infinity, -least}), -1);
  EXPECT_EQ(sign(Interval{0, 0}), 0);
  EXPECT_EQ(sign(Interval{0, 1}), std::nullopt);
  EXPECT_EQ(sign(any_number), std::nullopt);
  EXPECT_EQ(compare(Interval{1, 2}, Interval{3, infinity}), -1);
  EXPECT_EQ(compare(Interval{1, 2}, Interval{2, 3}), std::nullopt);
  EXPECT_EQ(compare(Interval{2, 2}, Interval{2, 2}), 0);
}

TEST(Interval, orientation_is_right_or_missing_for_random_doubles) {
  Random random(11);
  int certain = 0, uncertain = 0, zero = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto point = [&] {
      const double x = draw_double(random);
      return std::pair(x, one_in(random, 3) ? x : draw_double(random));
    };
    const auto a = point(), b = point();
    const double factor = one_in(random, 2) ? 3 : 1 + 0x1p-52;
    // Often on the line through a and b, or nearly.
    const auto c = one_in(random, 2) ? point()
                                     : std::pair(a.first + factor * (b.first - a.first),
                                                 a.second + factor * (b.second - a.second));
    if (!std::isfinite(c.first) || !std::isfinite(c.second)) continue;
    const auto exact = [](const auto& p) { return Point{Rational(p.first), Rational(p.second)}; };
    const int expected = orientation(exact(a), exact(b), exact(c));
    const std::optional<int> found =
        orientation(interval(exact(a)), interval(exact(b)), interval(exact(c)));
    ++(found ? certain : uncertain);
    if (found) {
      ASSERT_EQ(*found, expected);
    }
    zero += found == 0;
  }
  EXPECT_GT(certain, 5000);
  EXPECT_GT(uncertain, 1000);
  EXPECT_GT(zero, 50);
}

std::optional<int> turn(const Point& a, const Point& b, const Point& c) {
  return orientation(interval(a), interval(b), interval(c));
}

/// Points near a line, where naive doubles are wrong (Kettner and others, "Classroom examples of
/// robustness problems").
TEST(IntervalStage, in_doubles_is_right_for_all_numbers_inside_or_zero) {
  std::map<int, int> seen;
  for (int i = 0; i < 1200; ++i) {
    const double step = std::ldexp(1, -53 + i % 3 * 8);
    for (const double width : {0., 0x1p-53, 0x1p-50, 0x1p-20}) {
      for (const double far : {0., 0x1p-20}) {
        const double x = 0.5 + i / 3 % 20 * step, y = 0.5 + i / 60 * step;
        const std::array<IntervalPoint, 3> points{
            {{{x, x + width}, {y, y + width}}, {{12, 12}, {12, 12 + far}}, {{24, 24}, {24, 24}}}};
        for (std::size_t first = 0; first < 3; ++first) {
          const auto point = [&](std::size_t k) { return points[(first + k) % 3]; };
          const int sign = orientation_in_doubles(point(0), point(1), point(2));
          ++seen[sign];
          for (unsigned corner = 0; sign != 0 && corner < 64; ++corner) {
            const auto at = [&](std::size_t k) {
              const auto& [of_x, of_y] = point(k);
              return Point{corner >> k & 1 ? of_x.high : of_x.low,
                           corner >> (k + 3) & 1 ? of_y.high : of_y.low};
            };
            ASSERT_EQ(orientation(at(0), at(1), at(2)), sign);
          }
        }
      }
    }
  }
  for (const int sign : {-1, 0, 1}) EXPECT_GT(seen[sign], 1000) << sign;
}

TEST(IntervalStage, must_answer_for_small_integers) {
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y)
      ASSERT_EQ(turn({-2, -1}, {3, 2}, {x, y}),
                orientation(Point{-2, -1}, Point{3, 2}, Point{x, y}));
  }
  const int most = (1 << 26) - 1;
  ASSERT_EQ(turn({0, 0}, {most - 1, most - 1}, {most, most}), 0);
  ASSERT_EQ(turn({0, 0}, {most, most - 1}, {most - 1, most - 2}), -1);
}

TEST(IntervalStage, must_answer_for_products_that_round_to_the_same_double) {
  Random random(20261127);
  std::map<int, int> seen;
  for (int i = 0; i < 20000; ++i) {
    // (a b) - (a - k)(b + k) = k (a - b - k), of numbers of 53 bits.
    const auto a = static_cast<std::int64_t>(random() >> 11);
    const std::int64_t b = a - uniform(random, 0, 3), k = uniform(random, 0, 2);
    const auto exact = [](std::int64_t number) { return Rational(static_cast<double>(number)); };
    const Vector u{exact(a), exact(a - k)}, v{exact(b + k), exact(b)};
    const int right = sgn(cross(u, v));
    ASSERT_EQ(sign_of_cross(interval(u), interval(v)), right) << a << ' ' << b << ' ' << k;
    ++seen[right];
  }
  for (const int sign : {-1, 0, 1}) EXPECT_GT(seen[sign], 1000) << sign;
}

TEST(IntervalStage, must_not_answer_where_doubles_cannot_tell) {
  const Rational third(1, 3);
  EXPECT_FALSE(turn({0, 0}, {third, third}, {2 * third, 2 * third}));
  EXPECT_FALSE(turn({0, 0}, {1, 1}, {2, 2 + 1 / huge}));
  EXPECT_FALSE(turn({0, 0}, {huge, huge}, {huge, huge + 1}));
}

}  // namespace
}  // namespace oplus
