// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/sealed_report.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <nlohmann/json.hpp>

#include "checked/cli/version.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

/// A name that is no UTF-8 does not keep a report from being written.
std::string text_of(const nlohmann::ordered_json& report, int indent) {
  return report.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string checksum(const nlohmann::ordered_json& report) {
  return to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text_of(report, -1)));
}

}  // namespace

nlohmann::ordered_json begun_report(const std::string& command,
                                    const nlohmann::ordered_json& campaign, const Shard& shard) {
  return {{"report", command},
          {"version", version},
          {"campaign", campaign},
          {"shard", shard.index},
          {"shards", shard.of}};
}

std::string sealed(const nlohmann::ordered_json& report) {
  nlohmann::ordered_json text = report;
  text["checksum"] = checksum(report);
  return text_of(text, 2) + "\n";
}

nlohmann::ordered_json opened(const std::string& text, const std::string& file) {
  const auto refuse = [&](const std::string& wrong) {
    return InvalidInput({file, 1, 0}, wrong, "a report that oplus-check wrote with --report");
  };
  nlohmann::ordered_json report;
  try {
    report = nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::json::parse_error&) {
    throw refuse("no JSON, or truncated");
  }
  if (!report.is_object() || !report.contains("report") || !report["report"].is_string() ||
      !report.contains("version") || !report.contains("campaign") ||
      !report["campaign"].is_object() || !report.contains("shard") ||
      !report["shard"].is_number_unsigned() || !report.contains("shards") ||
      !report["shards"].is_number_unsigned() || !report.contains("checksum"))
    throw refuse("no report of a shard");
  const nlohmann::ordered_json said = report["checksum"];
  report.erase("checksum");
  if (!said.is_string() || said != checksum(report))
    throw refuse("its checksum is that of another report: it was changed");
  return report;
}

}  // namespace oplus
