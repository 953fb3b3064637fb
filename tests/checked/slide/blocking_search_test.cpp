// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/blocking_search.hpp"

#include <gtest/gtest.h>

#include <set>

#include "checked/slide/reduced_segments.hpp"
#include "checked/slide/slide.hpp"
#include "reference/families/family.hpp"
#include "reference/families/random.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

double per_segment(const char* quantity_wanted, const Region& p, const Region& q) {
  const Statistics statistics = slide_sum(p, q, Boundary::closed).statistics;
  const auto count = [&](const char* name) {
    for (const auto& [quantity, value] : statistics)
      if (quantity == name) return std::get<std::size_t>(value);
    return std::size_t{0};
  };
  EXPECT_GT(count("segments slid along"), 0u);
  return static_cast<double>(count(quantity_wanted)) /
         static_cast<double>(count("segments slid along"));
}

double boxes_per_segment(const Region& p, const Region& q) {
  return per_segment("pairs of boxes", p, q);
}

const Region hexagon = polygon({{0, 0}, {3, -1}, {5, 1}, {5, 3}, {2, 4}, {0, 2}});

/// Teeth of height 10 on a triangle whose third vertex is `far` below.
Region comb_with_outlier(int teeth, const Rational& far) {
  Chain chain{{0, -far}, {2 * teeth, 0}};
  for (int i = teeth; i-- > 0;) {
    chain.push_back({2 * i + 1, 10});
    chain.push_back({2 * i, 0});
  }
  return polygon(std::move(chain));
}

TEST(BlockingSearch, sees_detail_beside_a_vertex_that_is_far_away) {
  for (const int bits : {5, 29, 30, 50, 100})
    EXPECT_LT(boxes_per_segment(comb_with_outlier(500, slide::power_of_two(bits)), hexagon), 100)
        << bits;
}

TEST(BlockingSearch, does_not_depend_on_the_order_of_holes) {
  constexpr int k = 20;
  std::vector<Chain> holes;
  for (int i = 0; i < k * k; ++i) {
    const int x = i % k * 10, y = i / k * 10;
    holes.push_back(backwards(box(x + 3, y + 3, x + 7, y + 7)));
  }
  Random random(1);
  shuffle(random, holes);
  EXPECT_LT(boxes_per_segment({{{box(0, 0, 10 * k, 10 * k), holes}}}, polygon(box(0, 0, 1, 1))),
            100);
}

TEST(BlockingSearch, separates_long_slanted_teeth) {
  constexpr int teeth = 250, length = 1000;
  Chain chain{{-2, -2}, {4 * teeth - 2, -2}};
  for (int i = teeth; i-- > 0;) {
    chain.push_back({4 * i + 3, 0});
    chain.push_back({4 * i + 2 + length, length});
    chain.push_back({4 * i + 1 + length, length});
    chain.push_back({4 * i, 0});
  }
  EXPECT_LT(boxes_per_segment(polygon(std::move(chain)), hexagon), 200);
}

TEST(BlockingSearch, opens_few_boxes_that_are_only_touched) {
  const auto [p, q] = generate(*find_family("touching"), 60, 1);
  EXPECT_LT(boxes_per_segment(p, q), 80);
}

TEST(BlockingSearch, takes_few_rationals) {
  const auto [p, q] = generate(*find_family("fractions"), 100, 1);
  EXPECT_LT(per_segment("in rationals", p, q), 3);
}

/// Compares with all pairs of edges. Returns how many pairs were visited, and how many block something.
template <typename Numbers>
std::pair<std::size_t, std::size_t> expect_visits_what_blocks(const Region& p, const Region& q,
                                                              const slide::Scaling& scaling) {
  using namespace slide;
  const ReducedSegments<Numbers> segments(p, q, scaling);
  IntegerSummands<Numbers> summands(p, q, scaling, 0);
  BlockingSearch<Numbers> search(summands, Shift::to_the_right);
  std::size_t visits = 0, blocking = 0;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const ReducedSegment<Numbers> segment = segments[i];
    for (const Piece<Numbers>& piece :
         {Piece<Numbers>{{0, 1}, {1, 1}}, Piece<Numbers>{{1, 3}, {1, 2}}}) {
      std::set<EdgePair> visited;
      search.leave_out_all();
      search.each_pair(segment, piece, [&](const EdgePair& pair) { visited.insert(pair); });
      visits += visited.size();
      for (std::uint32_t e = 0; e < summands.p.edges.size(); ++e)
        for (std::uint32_t f = 0; f < summands.q.edges.size(); ++f) {
          const auto blocked = blocked_interval(segment.exact, summands.p.edges[e],
                                                summands.q.edges[f], Shift::to_the_right);
          if (!blocked || !(blocked->from < piece.to && piece.from < blocked->to)) continue;
          ++blocking;
          EXPECT_TRUE(visited.contains({e, f})) << i << ": " << e << ' ' << f;
        }
    }
  }
  return {visits, blocking};
}

TEST(BlockingSearch, visits_all_pairs_that_block) {
  using namespace slide;
  std::size_t visits = 0, blocking = 0;
  for (const char* family : {"grid", "touching", "star", "comb", "islands", "scales", "fractions"})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto [p, q] = generate(*find_family(family), 8, seed);
      SCOPED_TRACE(family);
      if (has_unlike_denominators(p, q)) {
        expect_visits_what_blocks<RationalNumbers>(p, q, scaling_of_rationals(p, q));
        continue;
      }
      const Scaling scaling = scaling_of(p, q);
      if (scaling.bits <= SmallNumbers::bits) {
        const auto [here, blocking_here] = expect_visits_what_blocks<SmallNumbers>(p, q, scaling);
        visits += here;
        blocking += blocking_here;
      }
      // No doubles are exact.
      Scaling larger = scaling;
      larger.denominator *= (mpz_class(1) << 40) + 1;
      larger.bits += 41;
      larger.shift = larger.bits > 60 ? larger.bits - 60 : 0;
      if (larger.bits <= WideNumbers::bits) expect_visits_what_blocks<WideNumbers>(p, q, larger);
    }
}

}  // namespace
}  // namespace oplus
