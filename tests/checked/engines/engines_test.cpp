// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/engines/engines.hpp"

#include <gtest/gtest.h>

#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/rca.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/operations/image.hpp"
#include "checked/slide/slide.hpp"
#include "properties/compare/corpus.hpp"
#include "reference/definitions/convolution.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(Engines, give_origins_only_where_they_are_asked_for) {
  const Region square = polygon(box(0, 0, 1, 1));
  for (const Engine& engine : engines()) {
    const auto origins = [&](const EngineOptions& options) {
      return engine.compute(square, square, Boundary::closed, options).origins;
    };
    EXPECT_TRUE(origins({}).empty()) << engine.name;
    EXPECT_EQ(origins({.with_origins = true}).size(), 4u) << engine.name;
  }
}

TEST(Engines, with_the_empty_region_are_empty) {
  const Region square = polygon(box(0, 0, 1, 1));
  for (const Engine& engine : engines_and_oracle()) {
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      for (const auto& [name, method] : hole_test_methods()) {
        const auto sum = [&, hole_test = method](const Region& p, const Region& q) {
          return engine.compute(p, q, boundary, {.with_origins = true, .hole_test = hole_test}).sum;
        };
        EXPECT_EQ(sum(Region{}, square), PlanarSet{}) << engine.name << ", " << name;
        EXPECT_EQ(sum(square, Region{}), PlanarSet{}) << engine.name << ", " << name;
        EXPECT_EQ(sum(Region{}, Region{}), PlanarSet{}) << engine.name << ", " << name;
      }
    }
  }
}

TEST(Engines, find_the_origins_of_the_definition) {
  std::size_t several = 0;
  std::size_t dangling = 0;
  for (const CorpusPair& row : corpus()) {
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      for (const Engine& engine : engines()) {
        const ComputedSum result = engine.compute(row.p, row.q, boundary, {.with_origins = true});
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
  // Wherever the chain of P starts, and so whichever segment is the first.
  for (const CorpusPair& row : corpus()) {
    if (row.open.dangling_edges.empty()) continue;
    Region p = row.p;
    for (std::size_t k = 0; k < p.components[0].outer.size(); ++k) {
      std::ranges::rotate(p.components[0].outer, p.components[0].outer.begin() + 1);
      const ComputedSum result = slide_sum(p, row.q, Boundary::open, {.with_origins = true});
      EXPECT_TRUE(result.origins == origins(result.sum, reduced_convolution(p, row.q)))
          << row.name << ", " << k;
    }
  }
  EXPECT_GT(several, 60u) << "no edge of several collinear pieces was seen";
  EXPECT_GT(dangling, 6u) << "no dangling edge was seen";
}

/// A shape without horizontal and vertical edges: its intersections need divisions.
Region star() {
  return polygon({{0, 0}, {7, 2}, {9, -3}, {8, 4}, {13, 9}, {6, 5}, {1, 8}, {3, 4}});
}

TEST(Engines, scale_with_their_summands_beyond_what_doubles_can_hold) {
  const Rational huge("1" + std::string(400, '0'));
  const Rational tiny = 1 / huge;
  std::vector<std::pair<Region, Region>> pairs = {{star(), star()}};
  for (const CorpusPair& row : corpus()) pairs.emplace_back(row.p, row.q);
  for (const auto& [p, q] : pairs) {
    const PlanarSet sum = rca(p, q, Boundary::open).sum;
    for (const auto& [x, y] : {std::pair{huge, huge}, {tiny, tiny}, {huge, tiny}, {tiny, huge}}) {
      const AffineMap scaled{x, 0, 0, y};
      const PlanarSet expected = image(scaled, sum);
      const Region large_p = image(scaled, p), large_q = image(scaled, q);
      for (const Engine& engine : engines()) {
        for (const auto& [name, method] : hole_test_methods()) {
          EXPECT_TRUE(engine.compute(large_p, large_q, Boundary::open, {.hole_test = method}).sum ==
                      expected)
              << engine.name << ", " << name;
        }
      }
    }
  }
}

TEST(Engines, are_found_by_their_names) {
  for (const Engine& engine : engines()) EXPECT_EQ(find_engine(engines(), engine.name), &engine);
  EXPECT_EQ(find_engine(engines(), "oracle"), nullptr);
  EXPECT_NE(find_engine(engines_and_oracle(), "oracle"), nullptr);
}

}  // namespace
}  // namespace oplus
