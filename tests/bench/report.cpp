// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "reference/io/number.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

using Json = nlohmann::ordered_json;

const Measurement* RowReport::of(const std::string& engine) const {
  const auto found = std::find_if(measurements.begin(), measurements.end(),
                                  [&](const Measurement& m) { return m.engine == engine; });
  return found == measurements.end() ? nullptr : &*found;
}

const Measurement* RowReport::done(const std::string& engine) const {
  const Measurement* found = of(engine);
  return found != nullptr && found->outcome == Outcome::done ? found : nullptr;
}

NLOHMANN_JSON_SERIALIZE_ENUM(Subject, {{Subject::sums, "sums"},
                                       {Subject::growth, "growth"},
                                       {Subject::convolution, "convolution"}})

void to_json(Json& json, const RowReport& row) {
  json = Json{{"name", row.name},
              {"group", row.group},
              {"what", row.what},
              {"subject", row.subject},
              {"pairs", row.pairs}};
  json["measurements"] = row.measurements;
}

void from_json(const Json& json, RowReport& row) {
  json.at("name").get_to(row.name);
  json.at("group").get_to(row.group);
  json.at("what").get_to(row.what);
  json.at("subject").get_to(row.subject);
  json.at("pairs").get_to(row.pairs);
  json.at("measurements").get_to(row.measurements);
}

void to_json(Json& json, const Setting& setting) {
  json = Json{{"processor", setting.processor}, {"cores", setting.cores},
              {"compiler", setting.compiler},   {"libraries", setting.libraries},
              {"command", setting.command},     {"limit", setting.limit},
              {"missing", setting.missing}};
}

void from_json(const Json& json, Setting& setting) {
  json.at("processor").get_to(setting.processor);
  json.at("cores").get_to(setting.cores);
  json.at("compiler").get_to(setting.compiler);
  json.at("libraries").get_to(setting.libraries);
  json.at("command").get_to(setting.command);
  json.at("limit").get_to(setting.limit);
  json.at("missing").get_to(setting.missing);
}

void to_json(Json& json, const Report& report) {
  json = Json::object();
  json["setting"] = report.setting;
  json["rows"] = report.rows;
}

void from_json(const Json& json, Report& report) {
  json.at("setting").get_to(report.setting);
  json.at("rows").get_to(report.rows);
}

namespace {

bool is_exact(const Measurement& m) {
  const BenchmarkedEngine* engine = find_benchmarked_engine(m.engine);
  return engine != nullptr && engine->arithmetic == Arithmetic::exact && m.outcome == Outcome::done;
}

}  // namespace

std::vector<const RowReport*> rows_for(const Report& report, Subject subject) {
  std::vector<const RowReport*> found;
  for (const RowReport& row : report.rows)
    if (row.subject == subject) found.push_back(&row);
  return found;
}

Agreement agreement_of(const RowReport& row) {
  Agreement agreement;
  std::map<std::string, std::string> engines_by_digest;
  for (const Measurement& m : row.measurements) {
    if (!is_exact(m)) continue;
    if (agreement.exact == nullptr) agreement.exact = &m;
    std::string& names = engines_by_digest[m.digest];
    names += (names.empty() ? "" : ", ") + m.engine;
  }
  if (engines_by_digest.size() > 1) {
    for (const auto& [digest, names] : engines_by_digest)
      agreement.disagreement += (agreement.disagreement.empty() ? "" : " against ") + names;
  }
  return agreement;
}

namespace {

Rational area_of(const Measurement& m) {
  NumberFault fault;
  const std::optional<Rational> area = parse_number(m.area, fault);
  if (!area) throw std::invalid_argument(m.engine + ": its area is no number: " + m.area);
  return *area;
}

}  // namespace

double absolute_area_error(const Measurement& rounded, const Measurement& exact) {
  return Rational(area_of(rounded) - area_of(exact)).get_d();
}

double relative_area_error(const Measurement& rounded, const Measurement& exact) {
  const Rational area = area_of(exact);
  return Rational((area_of(rounded) - area) / area).get_d();
}

}  // namespace oplus
