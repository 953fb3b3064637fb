// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace oplus {

NLOHMANN_JSON_SERIALIZE_ENUM(Subject, {{Subject::sums, "sums"},
                                       {Subject::growth, "growth"},
                                       {Subject::commands, "commands"},
                                       {Subject::certificates, "certificates"},
                                       {Subject::convolution, "convolution"},
                                       {Subject::hole_tests, "hole tests"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Measurement::Ending,
                             {{Measurement::Ending::failed, "failed"},
                              {Measurement::Ending::done, "done"},
                              {Measurement::Ending::over_limit, "over the limit"},
                              {Measurement::Ending::out_of_memory, "out of memory"},
                              {Measurement::Ending::crashed, "crashed"},
                              {Measurement::Ending::unsupported, "unsupported"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measurement, engine, outcome, note, digest, area, numbers)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Row, name, group, what, subject, pairs, measurements)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Setting, processor, cores, compiler, libraries, commit, command,
                                   limit, missing)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Report, setting, rows)

namespace {

using Json = nlohmann::json;

template <typename T>
T read(const std::string& json) {
  try {
    return Json::parse(json).get<T>();
  } catch (const Json::exception& e) {
    throw std::invalid_argument(std::string("not what --json writes: ") + e.what());
  }
}

}  // namespace

std::string to_json(const Report& report) { return Json(report).dump(1) + '\n'; }

/// The message of an exception may be invalid UTF-8.
std::string to_json(const Measurement& measurement) {
  return Json(measurement).dump(-1, ' ', false, Json::error_handler_t::replace);
}

Report report_of(const std::string& json) { return read<Report>(json); }
Measurement measurement_of(const std::string& json) { return read<Measurement>(json); }

}  // namespace oplus
