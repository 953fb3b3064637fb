// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/engine.hpp"

#include <gtest/gtest.h>

#include "reference/definitions/convolution.hpp"
#include "reference/oracle/oracle.hpp"
#include "tests/corpus/corpus.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

constexpr HoleTestMethod bvh = HoleTestMethod::hierarchy;

std::vector<Engine> checked_engines() {
  std::vector<Engine> checked = engines();
  std::erase_if(checked, [](const Engine& engine) { return engine.name == "oracle"; });
  return checked;
}

TEST(Engines, are_the_oracle_on_pairs_of_shapes) {
  std::size_t with_features = 0;
  std::size_t with_holes = 0;
  const std::vector<Shape> all = shapes();
  for (std::size_t i = 0; i < all.size(); ++i) {
    // A third of all pairs, each shape with five others; sanitizers make the oracle slow.
    for (std::size_t j = i % 3; j < all.size(); j += 3) {
      const auto& [p_name, p] = all[i];
      const auto& [q_name, q] = all[j];
      const OracleSums expected = oracle_sums(p, q);
      for (const Engine& engine : checked_engines()) {
        ASSERT_EQ(engine.compute(p, q, Boundary::closed, WithOrigins::no, bvh).sum, expected.closed)
            << engine.name << ", " << p_name << " + " << q_name << ", closed";
        ASSERT_EQ(engine.compute(p, q, Boundary::open, WithOrigins::no, bvh).sum, expected.open)
            << engine.name << ", " << p_name << " + " << q_name << ", open";
      }
      if (expected.open != expected.closed) ++with_features;
      if (!expected.closed.holes.empty()) ++with_holes;
    }
  }
  EXPECT_GT(with_features, 10u);
  EXPECT_GT(with_holes, 5u);
}

TEST(Engines, with_the_empty_region_are_empty) {
  const Region square = polygon(box(0, 0, 1, 1));
  for (const Engine& engine : engines()) {
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      for (const auto& [name, method] : hole_test_methods()) {
        const auto sum = [&, hole_test = method](const Region& p, const Region& q) {
          return engine.compute(p, q, boundary, WithOrigins::yes, hole_test).sum;
        };
        EXPECT_EQ(sum(Region{}, square), MinkowskiSum{}) << engine.name << ", " << name;
        EXPECT_EQ(sum(square, Region{}), MinkowskiSum{}) << engine.name << ", " << name;
        EXPECT_EQ(sum(Region{}, Region{}), MinkowskiSum{}) << engine.name << ", " << name;
      }
    }
  }
}

TEST(Engines, find_the_origins_of_the_definition) {
  std::size_t several = 0;
  std::size_t dangling = 0;
  for (const Row& row : corpus()) {
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      for (const Engine& engine : checked_engines()) {
        const Computed result = engine.compute(row.p, row.q, boundary, WithOrigins::yes, bvh);
        ASSERT_TRUE(result.origins == origins(result.sum, reduced_convolution(row.p, row.q)))
            << row.name << ", " << engine.name;
        for (const auto& of_edge : result.origins) {
          EXPECT_FALSE(of_edge.empty()) << row.name << ", " << engine.name;
          if (of_edge.size() > 1) ++several;
        }
        dangling += result.sum.dangling_edges.size();
      }
    }
  }
  EXPECT_GT(several, 60u) << "no edge of several collinear pieces was seen";
  EXPECT_GT(dangling, 6u) << "no dangling edge was seen";
}

TEST(Engines, are_found_by_their_names) {
  for (const Engine& engine : engines()) EXPECT_EQ(find_engine(engine.name), &engine);
  EXPECT_EQ(find_engine("none"), nullptr);
}

}  // namespace
}  // namespace oplus
