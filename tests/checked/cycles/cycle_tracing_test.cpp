// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cycles/cycle_tracing.hpp"

#include <gtest/gtest.h>

#include "reference/definitions/tangent_set.hpp"
#include "tests/reference/definitions/pairs_of_shapes.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

TEST(TracedChain, tangent_sets_are_those_of_the_definition) {
  for (const Shape& shape : shapes()) {
    for (const Chain& chain : chains(shape.region)) {
      for (const Summand of : {Summand::P, Summand::Q}) {
        const TracedChain traced(chain, of);
        ASSERT_EQ(traced.size(), chain.size());
        for (std::size_t i = 0; i < chain.size(); ++i) {
          ASSERT_EQ(traced.is_reflex(i), is_reflex(corner_at(chain, i)));
          for (int x = -2; x <= 2; ++x) {
            for (int y = -2; y <= 2; ++y) {
              if (x == 0 && y == 0) continue;
              const Direction d{{x, y}, other(of)};
              ASSERT_EQ(traced.has_in_tangent_set(i, FilteredDirection(d)),
                        in_tangent_set(d, corner_at(chain, i)))
                  << shape.name << ", vertex " << i << ", " << testing::PrintToString(d.vector);
            }
          }
        }
      }
    }
  }
}

GridCycles traced(const Chain& p, const Chain& q) {
  return trace_cycles(TracedChain(p, Summand::P), TracedChain(q, Summand::Q));
}

TEST(CycleTracing, equal_directions_are_met_in_the_order_of_the_tie_rule) {
  const Chain square = box(0, 0, 1, 1);
  const GridCycles grid = traced(square, square);
  ASSERT_EQ(grid.cycles.size(), 1U);
  EXPECT_EQ(grid.cycles[0].i, 0U);
  EXPECT_EQ(grid.cycles[0].j, 0U);
  const std::vector<Summand> alternating{Summand::P, Summand::Q, Summand::P, Summand::Q,
                                         Summand::P, Summand::Q, Summand::P, Summand::Q};
  EXPECT_EQ(grid.cycles[0].steps, alternating);
}

TEST(CycleTracing, opposite_directions_are_no_ties) {
  const Chain triangle{{0, 0}, {2, 0}, {0, 2}};
  const Chain turned{{0, 0}, {-2, 0}, {0, -2}};
  const GridCycles grid = traced(triangle, turned);
  ASSERT_EQ(grid.cycles.size(), 1U);
  const auto& steps = grid.cycles[0].steps;
  ASSERT_EQ(steps.size(), 6U);
  for (std::size_t k = 0; k < steps.size(); ++k)
    EXPECT_NE(steps[k], steps[next(k, steps.size())]) << "a hexagon's sides alternate";
}

TEST(CycleTracing, looks_at_the_starts_and_at_what_is_between_the_ends_of_cycles) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const Chain& of_p = p.components[0].outer;
    const Chain& of_q = q.components[0].outer;
    const GridCycles grid = traced(of_p, of_q);
    std::size_t segments = 0;
    for (const GridCycle& cycle : grid.cycles) segments += cycle.steps.size();
    ASSERT_EQ(grid.states_looked_at + grid.cycles.size(), of_p.size() + of_q.size() - 1 + segments);
  });
}

TEST(CycleTracing, goes_round_a_reflex_vertex_in_a_cycle_of_its_own) {
  const Chain triangle{{0, 0}, {2, 0}, {1, 6}};
  // All directions of the triangle are in the tangent set of vertex 3, (4, 1).
  const Chain notched{{0, 0}, {8, 0}, {8, 9}, {4, 1}, {0, 9}};
  const GridCycles grid = traced(triangle, notched);
  ASSERT_EQ(grid.cycles.size(), 2U);
  EXPECT_EQ(grid.cycles[0].steps.size(), 3U + 5);
  EXPECT_EQ(grid.cycles[1].steps, std::vector<Summand>(3, Summand::P));
  EXPECT_EQ(grid.cycles[1].i, 0U) << "found from the first column only";
  EXPECT_EQ(grid.cycles[1].j, 3U);
}

}  // namespace
}  // namespace oplus
