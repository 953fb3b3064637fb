// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/bench/measurement.hpp"
#include "tests/bench/rows.hpp"

namespace oplus {

/// What was measured on a row.
struct RowReport {
  std::string name;
  std::string group;
  std::string what;
  Subject subject = Subject::sums;
  std::size_t pairs = 1;
  std::vector<Measurement> measurements;

  /// Returns nullptr where the engine was not asked, or, for `done`, did not get to the end.
  const Measurement* of(const std::string& engine) const;
  const Measurement* done(const std::string& engine) const;
};

/// Where and how a run was made.
struct Setting {
  std::string processor;
  unsigned cores = 0;
  std::string compiler;
  std::string libraries;
  std::string command;
  double limit = 0;
  std::vector<std::string> missing;  ///< published pairs that were not there
};

/// A run.
struct Report {
  Setting setting;
  std::vector<RowReport> rows;
};

void to_json(nlohmann::ordered_json& json, const RowReport& row);
void from_json(const nlohmann::ordered_json& json, RowReport& row);
void to_json(nlohmann::ordered_json& json, const Setting& setting);
void from_json(const nlohmann::ordered_json& json, Setting& setting);
void to_json(nlohmann::ordered_json& json, const Report& report);
void from_json(const nlohmann::ordered_json& json, Report& report);

/// That of this program on this machine.
Setting this_setting(const std::string& command, double limit);

/// The rows of a run that are for this.
std::vector<const RowReport*> rows_for(const Report& report, Subject subject);

/// What results say about each other.
struct Agreement {
  /// Empty if all exact engines that got to the end agree; else who differs from whom.
  std::string disagreement;
  /// What the exact engines found; nullptr if none got to the end.
  const Measurement* exact = nullptr;
};

Agreement agreement_of(const RowReport& row);

/// How far the area of a measurement is off: (its area - the exact one) / the exact one.
double relative_area_error(const Measurement& rounded, const Measurement& exact);
double absolute_area_error(const Measurement& rounded, const Measurement& exact);

}  // namespace oplus
