// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/measurement.hpp"

namespace oplus {

using Json = nlohmann::ordered_json;

NLOHMANN_JSON_SERIALIZE_ENUM(Outcome, {{Outcome::failed, "failed"},
                                       {Outcome::done, "done"},
                                       {Outcome::over_limit, "over the limit"},
                                       {Outcome::crashed, "crashed"},
                                       {Outcome::not_taken, "not taken"}})

namespace {

template <typename T>
void put(Json& json, const char* name, const std::optional<T>& value) {
  if (value) json[name] = *value;
}

template <typename T>
void get(const Json& json, const char* name, std::optional<T>& value) {
  if (json.contains(name)) value = json.at(name).get<T>();
}

}  // namespace

void to_json(Json& json, const Measurement& m) {
  json = Json{{"engine", m.engine}, {"outcome", m.outcome}};
  if (!m.note.empty()) json["note"] = m.note;
  json["peak_mb"] = m.peak_mb;
  if (m.outcome != Outcome::done) return;
  json["seconds"] = m.seconds;
  put(json, "seconds_evaluated", m.seconds_evaluated);
  json["runs"] = m.runs;
  json["busy"] = m.busy;
  json["outer"] = m.outer;
  json["holes"] = m.holes;
  json["vertices"] = m.vertices;
  json["area"] = m.area;
  if (!m.digest.empty()) json["digest"] = m.digest;
  put(json, "segments", m.segments);
  put(json, "steps", m.steps);
}

void from_json(const Json& json, Measurement& m) {
  m = Measurement{};
  json.at("engine").get_to(m.engine);
  json.at("outcome").get_to(m.outcome);
  m.note = json.value("note", "");
  json.at("peak_mb").get_to(m.peak_mb);
  if (m.outcome != Outcome::done) return;
  json.at("seconds").get_to(m.seconds);
  get(json, "seconds_evaluated", m.seconds_evaluated);
  json.at("runs").get_to(m.runs);
  json.at("busy").get_to(m.busy);
  json.at("outer").get_to(m.outer);
  json.at("holes").get_to(m.holes);
  json.at("vertices").get_to(m.vertices);
  json.at("area").get_to(m.area);
  m.digest = json.value("digest", "");
  get(json, "segments", m.segments);
  get(json, "steps", m.steps);
}

}  // namespace oplus
