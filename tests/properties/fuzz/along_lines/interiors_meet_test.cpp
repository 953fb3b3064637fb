// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/along_lines/interiors_meet.hpp"

#include <gtest/gtest.h>

#include "properties/fuzz/pair_mutation.hpp"
#include "properties/fuzz/realized_pair.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus::along_lines {
namespace {

/// What was compared with the definition, and how often the interiors met.
struct Compared {
  int points = 0;
  int meet = 0;
};

template <typename T>
void compare_at_vertex_sums(const Region& p, const Region& q, const Frame& frame, Random& random,
                            Compared& compared) {
  const VertexSums<T> sums = vertex_sums<T>(p, q, frame);
  const auto point = [&](std::size_t k) {
    return frame.back(Rational(as_mpz(sums.at[k].x)), Rational(as_mpz(sums.at[k].y)));
  };
  const auto expect_as_defined = [&](bool found, const Point& x) {
    const bool right = oplus::interiors_meet(p, translated(reflected(q), x));
    EXPECT_EQ(found, right) << compared.points;
    ++compared.points;
    compared.meet += right;
  };
  for (std::size_t k = 0; k < sums.size(); ++k) {
    expect_as_defined(interiors_meet_at(sums, sums.at[k], frame.bits), point(k));
    // And where a denominator is needed.
    const Point x =
        midpoint(point(k), midpoint(point(k), point(uniform_index(random, sums.size()))));
    expect_as_defined(interiors_meet_at(sums, frame.in(x), frame.bits), x);
  }
}

/// In the numbers of each size, at contacts of all kinds: each vertex sum is one.
TEST(InteriorsMeet, are_as_they_are_defined) {
  Random random(11);
  Compared in_64_bits, in_128_bits, in_gmp;
  std::string bytes;
  for (int i = 0; i < 100; ++i) {
    bytes = mutated_pair(random, one_in(random, 10) ? std::string() : bytes);
    const auto pair = realized(decoded(bytes));
    if (!pair || vertex_count(pair->summands.p) * vertex_count(pair->summands.q) > 50) continue;
    const auto& [p, q] = pair->summands;
    const Frame frame = frame_of(p, q);
    if (frame.bits <= 10)
      compare_at_vertex_sums<std::int64_t>(p, q, frame, random, in_64_bits);
    else
      compare_at_vertex_sums<mpz_class>(p, q, frame, random,
                                        frame.bits <= most_bits_in_128 ? in_128_bits : in_gmp);
  }
  for (const Compared& compared : {in_64_bits, in_128_bits, in_gmp}) {
    EXPECT_GT(compared.meet, 50);
    EXPECT_GT(compared.points - compared.meet, 50);
  }
}

}  // namespace
}  // namespace oplus::along_lines
