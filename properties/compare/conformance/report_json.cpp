// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "properties/compare/conformance/report.hpp"
#include "properties/compare/sealed_report.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/written.hpp"

namespace oplus {

namespace {

using Json = nlohmann::ordered_json;

std::string key(std::string words) {
  std::replace(words.begin(), words.end(), ' ', '_');
  return words;
}

Json to_json(const ConformanceTally& tally) {
  Json json = {{"pairs", tally.pairs}};
  for (const auto& [ruling, name] : rulings()) json[key(name)] = tally.count(ruling);
  json["kinds"] = Json::object();
  for (const auto& [kind, count] : tally.kinds) json["kinds"][kind] = count;
  return json;
}

ConformanceTally tally_of(const Json& json) {
  ConformanceTally tally;
  json.at("pairs").get_to(tally.pairs);
  for (const auto& [ruling, name] : rulings()) {
    const std::size_t count = json.at(key(name)).get<std::size_t>();
    if (count > 0) tally.rulings[ruling] = count;
  }
  for (const auto& [kind, count] : json.at("kinds").items())
    tally.kinds[kind] = count.get<std::size_t>();
  return tally;
}

Json to_json(const Point& p) { return {p.x.get_str(), p.y.get_str()}; }

Point point_of(const Json& json) {
  return {Rational(json.at(0).get<std::string>()), Rational(json.at(1).get<std::string>())};
}

Json to_json(const Chain& chain) {
  Json json = Json::array();
  for (const Point& p : chain) json.push_back(to_json(p));
  return json;
}

Chain chain_of(const Json& json) {
  Chain chain;
  for (const Json& p : json) chain.push_back(point_of(p));
  return chain;
}

/// Chain by chain, since a wrong sum need not be a region, which WKT could hold.
Json to_json(const MinkowskiSum& sum) {
  Json json = {{"outer", Json::array()},
               {"holes", Json::array()},
               {"dangling_edges", Json::array()},
               {"isolated_vertices", to_json(sum.isolated_vertices)}};
  for (const Chain& chain : sum.outer) json["outer"].push_back(to_json(chain));
  for (const Chain& hole : sum.holes) json["holes"].push_back(to_json(hole));
  for (const Segment& e : sum.dangling_edges)
    json["dangling_edges"].push_back({to_json(e.source), to_json(e.target)});
  return json;
}

MinkowskiSum sum_of(const Json& json) {
  MinkowskiSum sum;
  for (const Json& chain : json.at("outer")) sum.outer.push_back(chain_of(chain));
  for (const Json& hole : json.at("holes")) sum.holes.push_back(chain_of(hole));
  for (const Json& e : json.at("dangling_edges"))
    sum.dangling_edges.push_back({point_of(e.at(0)), point_of(e.at(1))});
  sum.isolated_vertices = chain_of(json.at("isolated_vertices"));
  return sum;
}

Region region_of(const Json& json) {
  std::istringstream in(json.get<std::string>());
  return read_region(in, "a counterexample").region;
}

Json to_json(const ConformanceReport& report, const ShrunkFailure& counterexample) {
  const SeenFailure& seen = counterexample.seen;
  const CounterexampleFiles files = files_of(counterexample);
  Json json = {{"kind", seen.failure.kind},       {"what", seen.failure.what},
               {"boundary", name(seen.boundary)}, {"vertices", size_of(seen.summands).vertices},
               {"p", wkt(seen.summands.p)},       {"q", wkt(seen.summands.q)}};
  if (seen.right) json["right"] = to_json(*seen.right);
  if (seen.given) json["given"] = to_json(*seen.given);
  if (seen.failure.witness) json["witness"] = to_json(*seen.failure.witness);
  if (seen.failure.squared_distance)
    json["squared_distance"] = seen.failure.squared_distance->get_str();
  json["found_in"] = counterexample.found_in;
  json["group"] = counterexample.group;
  json["trial"] = counterexample.index;
  json["found_vertices"] = counterexample.found_size.vertices;
  json["found_coordinates"] = counterexample.found_size.coordinates.get_str();
  json["tries"] = counterexample.tries;
  json["is_shrunk"] = counterexample.is_shrunk;
  json["is_repeatable"] = counterexample.is_repeatable;
  json["files"] = {files.p, files.q};
  for (const std::string& file : {files.right, files.given, files.picture})
    if (!file.empty()) json["files"].push_back(file);
  json["replay"] = replay_line(report, counterexample);
  return json;
}

ShrunkFailure counterexample_of(const Json& json) {
  ShrunkFailure result;
  SeenFailure& seen = result.seen;
  json.at("kind").get_to(seen.failure.kind);
  json.at("what").get_to(seen.failure.what);
  seen.boundary = boundary_named(json.at("boundary"));
  seen.summands = {region_of(json.at("p")), region_of(json.at("q"))};
  if (json.contains("right")) seen.right = sum_of(json["right"]);
  if (json.contains("given")) seen.given = sum_of(json["given"]);
  if (json.contains("witness")) seen.failure.witness = point_of(json["witness"]);
  if (json.contains("squared_distance"))
    seen.failure.squared_distance = Rational(json["squared_distance"].get<std::string>());
  json.at("found_in").get_to(result.found_in);
  json.at("group").get_to(result.group);
  json.at("trial").get_to(result.index);
  json.at("found_vertices").get_to(result.found_size.vertices);
  result.found_size.coordinates = Rational(json.at("found_coordinates").get<std::string>());
  json.at("tries").get_to(result.tries);
  json.at("is_shrunk").get_to(result.is_shrunk);
  json.at("is_repeatable").get_to(result.is_repeatable);
  return result;
}

}  // namespace

Json campaign_of(const ConformanceReport& report) {
  const ConformanceSettings& settings = report.settings;
  Json json = {{"engine", report.engine}, {"seed", settings.seed}};
  if (settings.cases)
    json["cases"] = *settings.cases;
  else
    json["budget"] = settings.budget;
  json["parts"] = settings.parts;
  json["largest"] = settings.largest;
  json["shrink"] = settings.shrink_tries;
  json["time_limit"] = settings.limits.seconds;
  json["memory_limit"] = settings.limits.memory_mb;
  json["pairs"] = report.pairs;
  json["groups"] = Json::array();
  for (const TrialGroup& group : report.groups)
    json["groups"].push_back({{"part", group.part}, {"name", group.name}, {"pairs", group.pairs}});
  return json;
}

Json to_json(const ConformanceReport& report) {
  Json json = begun_report("conformance", campaign_of(report), report.settings.shard);
  json["conforms"] = report.conforms();
  json["all"] = to_json(report.all());
  json["groups"] = Json::array();
  for (std::size_t i = 0; i < report.groups.size(); ++i) {
    Json group = {{"part", report.groups[i].part}, {"name", report.groups[i].name}};
    group.update(to_json(report.tallies[i]));
    json["groups"].push_back(std::move(group));
  }
  json["counterexamples"] = Json::array();
  for (const auto& [kind, counterexample] : report.counterexamples)
    json["counterexamples"].push_back(to_json(report, counterexample));
  return json;
}

ConformanceReport conformance_of_json(const Json& json) {
  ConformanceReport report;
  const Json& campaign = json.at("campaign");
  ConformanceSettings& settings = report.settings;
  campaign.at("engine").get_to(report.engine);
  campaign.at("seed").get_to(settings.seed);
  if (campaign.contains("cases"))
    settings.cases = campaign["cases"].get<std::size_t>();
  else
    campaign.at("budget").get_to(settings.budget);
  campaign.at("parts").get_to(settings.parts);
  campaign.at("largest").get_to(settings.largest);
  campaign.at("shrink").get_to(settings.shrink_tries);
  campaign.at("time_limit").get_to(settings.limits.seconds);
  campaign.at("memory_limit").get_to(settings.limits.memory_mb);
  campaign.at("pairs").get_to(report.pairs);
  json.at("shard").get_to(settings.shard.index);
  json.at("shards").get_to(settings.shard.of);
  for (const Json& group : campaign.at("groups"))
    report.groups.push_back({group.at("part").get<std::string>(),
                             group.at("name").get<std::string>(),
                             group.at("pairs").get<std::size_t>()});
  for (const Json& group : json.at("groups")) report.tallies.push_back(tally_of(group));
  if (report.tallies.size() != report.groups.size())
    throw InvalidInput({"", 1, 0}, "counts of other groups than the campaign's", "one a group");
  for (const Json& counterexample : json.at("counterexamples")) {
    ShrunkFailure read = counterexample_of(counterexample);
    report.counterexamples.emplace(read.seen.failure.kind, std::move(read));
  }
  return report;
}

}  // namespace oplus
