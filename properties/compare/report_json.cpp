// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/report_json.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <nlohmann/json.hpp>

#include "properties/compare/counterexample_files.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

using Json = nlohmann::json;

template <>
struct nlohmann::adl_serializer<oplus::Rational> {
  static void to_json(Json& json, const oplus::Rational& value) { json = value.get_str(); }
  static void from_json(const Json& json, oplus::Rational& value) {
    value = oplus::Rational(json.get<std::string>());
  }
};

template <typename Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
  static void to_json(Json& json, const std::optional<Value>& value) {
    json = value ? Json(*value) : Json();
  }
  static void from_json(const Json& json, std::optional<Value>& value) {
    value.reset();
    if (!json.is_null()) value = json.get<Value>();
  }
};

namespace oplus {

namespace {

/// A report is written even where a name is not valid UTF-8.
std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string checksum(const Json& json) {
  return to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text_of(json, -1)));
}

}  // namespace

void to_json(Json& json, const Point& p) { json = {p.x, p.y}; }
void from_json(const Json& json, Point& p) {
  p = {json.at(0).get<Rational>(), json.at(1).get<Rational>()};
}
void to_json(Json& json, const Segment& s) { json = {s.source, s.target}; }
void from_json(const Json& json, Segment& s) {
  s = {json.at(0).get<Point>(), json.at(1).get<Point>()};
}
void to_json(Json& json, const Region& region) {
  json = is_unbounded(region) ? written(region, Format::dat) : wkt(region);
}
void from_json(const Json& json, Region& region) {
  region = read_region(json.get<std::string>(), "a counterexample", {}, Extent::any).region;
}
void to_json(Json& json, Boundary boundary) { json = name(boundary); }
void from_json(const Json& json, Boundary& boundary) {
  boundary = boundary_named(json.get<std::string>());
}
void to_json(Json& json, const SumDigest& digest) { json = digest.to_string(); }
void from_json(const Json& json, SumDigest& digest) { digest = SumDigest(json.get<std::string>()); }

// Chain by chain, since a wrong sum need not be a region, as WKT requires.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PlanarSet, outer, holes, dangling_edges, isolated_vertices,
                                   is_unbounded)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Summands, p, q)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Size, vertices, coordinates)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Failure, kind, what, witness, squared_distance)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WrongSum, engine, boundary, failure, pair, right, given)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ShrunkFailure, sum, found_in, source, index, found_size, tries,
                                   is_shrunk, is_repeatable)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SkippedPairs, times, index, first)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Tally, pairs, ran, skipped, disagreed, holes_in_sum,
                                   holes_in_summand, low_dimensional_features, overlapping_segments,
                                   several_components, face_probes, point_probes, sums, values,
                                   kinds, open_unsupported, refused)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FirstFailure, index, found_in, what, pair)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CountedSource, part, name, counts, first_failures)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Campaign, engines, hole_test, judge, operation, seed, n, largest,
                                   shrink, shrink_tries, time_limit, memory_limit, pairs, sources)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Shard, index, of)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CampaignReport, report, version, campaign, shard, pairs, done,
                                   has_stopped_shrinking, out, sources, skipped, counterexamples,
                                   digest)

std::string sealed(const CampaignReport& report) {
  Json json = report;
  // Not read again: they follow from the rest.
  json["all"] = report.all();
  json["interrupted"] = report.is_interrupted();
  for (const auto& [kind, found] : report.counterexamples) {
    Json& entry = json["counterexamples"][kind];
    entry["files"] = files_of(found).all();
    entry["replay"] = replay_line(report, found);
  }
  json["checksum"] = checksum(json);
  return text_of(json, 2) + "\n";
}

CampaignReport opened(const std::string& text, const std::string& file) {
  const auto refuse = [&](const std::string& wrong) {
    return InvalidInput({file, 1, 0}, wrong, "a report that oplus-check wrote with --report");
  };
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw refuse("invalid or truncated JSON");
  if (!json.is_object() || !json.contains("checksum")) throw refuse("not a report of a shard");
  const Json said = json["checksum"];
  json.erase("checksum");
  if (said != checksum(json)) throw refuse("its checksum does not match: it was changed");
  try {
    auto report = json.get<CampaignReport>();
    if (report.done > report.pairs || report.sources.size() != report.campaign.sources.size())
      throw refuse("its counts contradict each other");
    judge_named(report.campaign.judge);
    return report;
  } catch (const nlohmann::json::exception& e) {
    throw refuse(e.what());
  } catch (const std::invalid_argument& e) {
    throw refuse(e.what());
  }
}

std::string other_campaign(const CampaignReport& expected, const CampaignReport& found) {
  const auto difference = [](const Json& one, const Json& other) -> std::string {
    for (const auto& [key, value] : one.items()) {
      const auto shown = [&](const Json& of) {
        const std::string all = text_of(of.at(key), -1);
        return all.size() <= 60 ? all : all.substr(0, 57) + "...";
      };
      if (other.at(key) != value) return key + " is " + shown(other) + ", not " + shown(one);
    }
    return "";
  };
  const auto command = [](const CampaignReport& of) -> Json {
    return {{"report", of.report}, {"version", of.version}, {"shards", of.shard.of}};
  };
  const std::string other = difference(command(expected), command(found));
  return !other.empty() ? other : difference(expected.campaign, found.campaign);
}

}  // namespace oplus
