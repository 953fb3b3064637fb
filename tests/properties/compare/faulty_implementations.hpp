// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "checked/slide/slide.hpp"
#include "properties/compare/conformance_sources.hpp"
#include "properties/compare/run_campaign.hpp"
#include "properties/runner/checked_engines.hpp"

namespace oplus {

/// slide, its sum changed.
inline Engine changed(const std::function<void(MinkowskiSum& sum)>& change) {
  return named_engine("changed", [change](const Region& p, const Region& q, Boundary boundary) {
    MinkowskiSum sum = slide_sum(p, q, boundary).sum;
    change(sum);
    return sum;
  });
}

/// slide, but for pairs of which something holds.
inline Engine failing(const std::function<bool(const Summands&)>& fails,
                      const std::function<MinkowskiSum()>& failure) {
  return named_engine("failing", [=](const Region& p, const Region& q, Boundary boundary) {
    if (fails({p, q})) return failure();
    return slide_sum(p, q, boundary).sum;
  });
}

/// Tries what it is asked with several faults: invents a vertex, and crashes now and then.
inline Engine of_many_kinds(const std::string& name) {
  return named_engine(name,
                      [](const Region& p, const Region& q, Boundary boundary) -> MinkowskiSum {
                        MinkowskiSum sum = slide_sum(p, q, boundary).sum;
                        if (vertex_count(p) == 5)
                          throw NoSum(NoSum::Kind::crashed, "x < y && z|w", "it <died>\n");
                        if (vertex_count(p) == 6) std::swap(sum.outer[0][0], sum.outer[0][1]);
                        if (vertex_count(q) == 4) sum.isolated_vertices.push_back({1000, 1000});
                        return sum;
                      });
}

/// A run of so many pairs of each source of some parts; by default of those that need nothing but the
/// oracle: grids, whose pairs are small and have no holes, and families.
struct SmallRun {
  std::vector<std::string> parts = {"grids", "families"};
  std::size_t cases = 4;
  std::size_t shrink_tries = 150;
  std::size_t largest = 1300;
  Shard shard = {};
  unsigned threads = 2;

  std::vector<TaskSource> sources() const {
    return conformance_sources({.cases = cases, .parts = parts});
  }

  CampaignReport of(const Engine& engine) const {
    Campaign campaign;
    campaign.engines = {engine.name};
    campaign.shrink_tries = shrink_tries;
    campaign.largest = largest;
    return run_campaign(begun_report("conformance", campaign, shard, sources()), sources(),
                        {.engines = {engine}, .largest = largest, .asks_beyond = true}, threads);
  }
};

}  // namespace oplus
