// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cycles/fiber_grid.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/reference/definitions/pairs_of_shapes.hpp"

namespace oplus {
namespace {

using State = std::pair<std::size_t, std::size_t>;

State source(const FiberGrid::Edge& e) { return {e.i, e.j}; }

State target(const FiberGrid::Edge& e, const FiberGrid& grid) {
  return e.along == Summand::P ? State{next(e.i, grid.n), e.j} : State{e.i, next(e.j, grid.m)};
}

TEST(FiberGrid, has_an_edge_for_each_segment_of_the_convolution) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const Chain& of_p = p.components[0].outer;
    const Chain& of_q = q.components[0].outer;
    const FiberGrid grid = fiber_grid(of_p, of_q);
    std::map<std::tuple<std::size_t, std::size_t, Summand>, int> seen;
    for (const FiberGrid::Edge& e : grid.edges) ++seen[{e.i, e.j, e.along}];
    const auto all = convolution(polygon(of_p), polygon(of_q));
    ASSERT_EQ(grid.edges.size(), all.size());
    for (const auto& [segment, origin, reflex] : all) {
      const bool edge_of_p = origin.edge_of == Summand::P;
      const std::size_t i = (edge_of_p ? origin.edge : origin.vertex).vertex;
      const std::size_t j = (edge_of_p ? origin.vertex : origin.edge).vertex;
      ASSERT_EQ((seen[{i, j, origin.edge_of}]), 1);
    }
  });
}

TEST(FiberGrid, lists_its_cycles_one_after_another_each_closed) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const FiberGrid grid = fiber_grid(p.components[0].outer, q.components[0].outer);
    ASSERT_EQ(grid.edges.front().cycle, 0U);
    ASSERT_EQ(grid.edges.back().cycle + 1, grid.cycles);
    State start = source(grid.edges.front());
    for (std::size_t k = 0; k < grid.edges.size(); ++k) {
      const State reached = target(grid.edges[k], grid);
      if (k + 1 < grid.edges.size() && grid.edges[k + 1].cycle == grid.edges[k].cycle) {
        ASSERT_EQ(reached, source(grid.edges[k + 1]));
      } else {
        ASSERT_EQ(reached, start);
        if (k + 1 == grid.edges.size()) break;
        ASSERT_EQ(grid.edges[k + 1].cycle, grid.edges[k].cycle + 1);
        start = source(grid.edges[k + 1]);
      }
    }
  });
}

}  // namespace
}  // namespace oplus
