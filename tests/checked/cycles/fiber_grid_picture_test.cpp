// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cycles/fiber_grid_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/families/polygons.hpp"
#include "tests/reference/definitions/pairs_of_shapes.hpp"
#include "tests/reference/pictures/parsed_picture.hpp"

namespace oplus {
namespace {

using boost::property_tree::ptree;

const Chain l_shape{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};

std::vector<ptree> children(const ptree& tree, const std::string& wanted,
                            const std::string& of_class = "") {
  std::vector<ptree> found;
  for (const auto& [tag, child] : tree) {
    if (tag == wanted && child.get<std::string>("<xmlattr>.class", "") == of_class)
      found.push_back(child);
  }
  return found;
}

std::vector<std::string> texts(const ptree& group) {
  std::vector<std::string> result;
  for (const ptree& text : children(group, "text")) result.push_back(text.data());
  return result;
}

TEST(FiberGridPicture,
     draws_every_edge_in_its_cycle_and_repeats_those_of_the_first_row_and_column) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const FiberGrid grid = fiber_grid(p.components[0].outer, q.components[0].outer);
    const ptree picture = parsed(svg(grid));
    const std::vector<ptree> cycles = groups(picture, "cycle");
    ASSERT_EQ(cycles.size(), grid.cycles);
    std::size_t edges = 0, repeated = 0;
    for (const ptree& cycle : cycles) {
      edges += children(cycle, "path").size();
      EXPECT_EQ(children(cycle, "circle", "start").size(), 1U);
      for (const ptree& again : groups(cycle, "repeated"))
        repeated += children(again, "path").size();
    }
    const auto on_the_rim = std::count_if(grid.edges.begin(), grid.edges.end(), [](const auto& e) {
      return (e.along == Summand::P ? e.j : e.i) == 0;
    });
    ASSERT_EQ(edges, 2 * grid.edges.size()) << "a line and a head each";
    ASSERT_EQ(repeated, 2 * static_cast<std::size_t>(on_the_rim));
    const ptree states = groups(picture, "states").at(0);
    ASSERT_EQ(children(states, "circle").size(), (grid.n + 1) * (grid.m + 1));
  });
}

TEST(FiberGridPicture, says_how_large_it_is_and_how_its_cycles_go_round) {
  const ptree picture = parsed(svg(fiber_grid(l_shape, box(0, 0, 1, 1))));
  EXPECT_EQ(texts(picture), std::vector<std::string>{"Fiber grid: n = 6, m = 4, K = 14, 1 cycle"});
  EXPECT_EQ(texts(groups(picture, "legend").at(0)),
            std::vector<std::string>{"14 segments: P 1\u00d7, Q 2\u00d7"});
  EXPECT_EQ(texts(groups(picture, "axes").at(0)),
            (std::vector<std::string>{"0", "1", "2", "3", "4", "5", "0", "0", "1", "2", "3", "0",
                                      "vertex of P", "vertex of Q"}));
}

TEST(FiberGridPicture, of_a_large_grid_leaves_out_labels_and_states_that_no_cycle_passes) {
  Random random(3);
  const Chain p = convex_polygon(random, 150).components[0].outer;
  const Chain q = convex_polygon(random, 150).components[0].outer;
  const std::string picture = svg(fiber_grid(p, q));
  const ptree tree = parsed(picture);
  EXPECT_LT(children(groups(tree, "states").at(0), "circle").size(), 1000U);
  EXPECT_EQ(texts(groups(tree, "axes").at(0)).size(), 2U * 31 + 2);
  EXPECT_EQ(picture, svg(fiber_grid(p, q)));
}

TEST(FiberGridPicture, names_no_more_cycles_than_fit) {
  Chain saw{{0, 0}, {160, 0}, {160, 9}};
  for (int x = 156; x > 0; x -= 8) saw.insert(saw.end(), {{x, 1}, {x - 4, 9}});
  const FiberGrid grid = fiber_grid(saw, {{0, 0}, {2, 0}, {1, 6}});
  ASSERT_EQ(grid.cycles, 21U) << "one for each reflex vertex, one for the rest";
  const ptree legend = groups(parsed(svg(grid)), "legend").at(0);
  const std::vector<std::string> rows = texts(legend);
  ASSERT_EQ(rows.size(), 17U);
  EXPECT_EQ(rows.back(), "and 5 more");
}

}  // namespace
}  // namespace oplus
