// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/exhaustive/exhaustive_run.hpp"

#include <nlohmann/json.hpp>

#include "checked/cli/version.hpp"
#include "properties/compare/exhaustive/grid_polygons.hpp"
#include "properties/compare/sealed_report.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

constexpr std::size_t pairs_at_a_time = 256;

Shard shard_of(const Scope& scope) { return {scope.shard, scope.shards}; }

void add(const DifferentialResult& result, std::size_t orbit, ExhaustiveState& state) {
  state.holes_in_sum += result.holes_in_sum;
  state.low_dimensional_features += result.low_dimensional_features;
  state.overlapping_segments += result.overlapping_segments;
  state.disagreed += result.kind == DifferentialResult::Kind::disagreed;
  if (result.by_oracle) state.digest.add(orbit, result.by_oracle->closed, result.by_oracle->open);
}

}  // namespace

std::string to_json(const ExhaustiveState& state) {
  nlohmann::ordered_json json = begun_report("exhaustive",
                                             {{"grid", state.scope.side},
                                              {"vertices", state.scope.most_vertices},
                                              {"engines", state.engines}},
                                             shard_of(state.scope));
  json.update({{"polygons", state.polygons},
               {"pairs", state.pairs},
               {"done", state.done},
               {"holes_in_sum", state.holes_in_sum},
               {"low_dimensional_features", state.low_dimensional_features},
               {"overlapping_segments", state.overlapping_segments},
               {"disagreed", state.disagreed},
               {"digest", state.digest.to_string()}});
  return sealed(json);
}

ExhaustiveState state_of_json(const std::string& text, const std::string& file) {
  const auto refuse = [&](const std::string& wrong) {
    return InvalidInput({file, 1, 0}, wrong, "a state that oplus-check exhaustive wrote");
  };
  const nlohmann::ordered_json json = opened(text, file);
  if (json.at("report") != "exhaustive") throw refuse("another command's report");
  if (json.at("version") != version) throw refuse("the state of another version");
  try {
    ExhaustiveState state;
    const nlohmann::ordered_json& campaign = json.at("campaign");
    campaign.at("grid").get_to(state.scope.side);
    campaign.at("vertices").get_to(state.scope.most_vertices);
    campaign.at("engines").get_to(state.engines);
    json.at("shard").get_to(state.scope.shard);
    json.at("shards").get_to(state.scope.shards);
    json.at("polygons").get_to(state.polygons);
    json.at("pairs").get_to(state.pairs);
    json.at("done").get_to(state.done);
    json.at("holes_in_sum").get_to(state.holes_in_sum);
    json.at("low_dimensional_features").get_to(state.low_dimensional_features);
    json.at("overlapping_segments").get_to(state.overlapping_segments);
    json.at("disagreed").get_to(state.disagreed);
    state.digest = SumDigest(json.at("digest").get<std::string>());
    if (state.done > state.pairs) throw refuse("more pairs are done than there are");
    return state;
  } catch (const nlohmann::json::exception& e) {
    throw refuse(e.what());
  } catch (const std::invalid_argument& e) {
    throw refuse(e.what());
  }
}

ExhaustiveState run_exhaustively(ExhaustiveState state, const std::vector<Engine>& implementations,
                                 unsigned threads, const ExhaustiveReports& reports) {
  const std::vector<GridPolygon> polygons =
      grid_polygons(state.scope.side, state.scope.most_vertices);
  const auto orbits = pair_orbits(polygons);
  const std::vector<std::size_t> of_shard = shard_of(state.scope).cases_of(orbits.size());
  state.polygons = polygons.size();
  state.pairs = of_shard.size();
  while (state.done < state.pairs && !reports.is_enough()) {
    const std::size_t end = std::min(state.done + pairs_at_a_time, state.pairs);
    std::vector<DifferentialCase> cases;
    for (std::size_t k = state.done; k < end; ++k) {
      const auto [i, j] = orbits[of_shard[k]];
      cases.push_back({"pair " + std::to_string(of_shard[k]), "exhaustive",
                       [p = region_of(polygons[i]), q = region_of(polygons[j])] {
                         return Summands{p, q};
                       }});
    }
    std::vector<std::pair<std::size_t, Disagreement>> found;
    run_differential(cases, implementations, static_cast<std::size_t>(-1), threads,
                     [&](std::size_t index, const DifferentialResult& result) {
                       add(result, of_shard[state.done + index], state);
                       if (result.disagreement) found.emplace_back(index, *result.disagreement);
                     });
    for (const auto& [index, disagreement] : found)
      reports.disagreement(cases[index].name, cases[index].make(), disagreement);
    state.done = end;
    reports.after_some(state);
  }
  return state;
}

}  // namespace oplus
