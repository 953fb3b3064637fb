// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "checked/slide/slide.hpp"
#include "properties/compare/conformance_sources.hpp"
#include "properties/compare/run_campaign.hpp"
#include "properties/runner/checked_engines.hpp"

namespace oplus {

/// slide, with a fault that changes its sum or throws.
inline Engine faulty(
    const std::string& name,
    const std::function<void(PlanarSet& sum, const Summands& pair, Boundary boundary)>& fault) {
  return named_engine(name, [fault](const Region& p, const Region& q, Boundary boundary) {
    PlanarSet sum = slide_sum(p, q, boundary).sum;
    fault(sum, {p, q}, boundary);
    return sum;
  });
}

/// slide, each sum changed.
inline Engine changed(const std::function<void(PlanarSet& sum)>& change) {
  return faulty("changed", [change](PlanarSet& sum, const Summands&, Boundary) { change(sum); });
}

/// Tries what it is asked with several faults: invents a vertex, and crashes now and then.
inline Engine of_many_kinds(const std::string& name) {
  return faulty(name, [](PlanarSet& sum, const Summands& pair, Boundary) {
    if (vertex_count(pair.p) == 5)
      throw EngineFailure(EngineFailure::Kind::crashed, "x < y && z|w", "it <died>\n");
    if (vertex_count(pair.p) == 6) std::swap(sum.outer[0][0], sum.outer[0][1]);
    if (vertex_count(pair.q) == 4) sum.isolated_vertices.push_back({1000, 1000});
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
  std::string judge = "oracle";

  std::vector<TaskSource> sources() const {
    return conformance_sources({.cases = cases, .parts = parts});
  }

  CampaignReport of(const Engine& engine) const {
    Campaign campaign;
    campaign.engines = {engine.name};
    campaign.shrink_tries = shrink_tries;
    campaign.largest = largest;
    campaign.judge = judge;
    return run_campaign(
        begun_report("conformance", campaign, shard, sources()), sources(),
        {.engines = {engine}, .largest = largest, .asks_beyond = true, .judge = judge_named(judge)},
        threads);
  }
};

}  // namespace oplus
