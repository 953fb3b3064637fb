// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/engine_plots.hpp"

namespace oplus {

namespace {

constexpr const char* of_rca = "#0072b2";
constexpr const char* of_winding = "#d55e00";
constexpr const char* vertices_of_p = "vertices of P";

}  // namespace

std::optional<Plot> EnginePlots::times(const std::string& name, const std::string& title,
                                       const std::string& x_column, const std::string& x_label,
                                       const std::optional<Fit>& rca,
                                       const std::optional<Fit>& winding) const {
  return plot_of(name, csv, table, {title, x_column, x_label, "seconds, without output"},
                 {{"rca_time", "RCA (rca)", of_rca, rca, ""},
                  {"winding_time", "CWEIN (winding)", of_winding, winding, ""}});
}

std::optional<Plot> EnginePlots::memory(const std::string& name, const std::string& title) const {
  return plot_of(name, csv, table, {title, "m", vertices_of_p, "peak memory, MB"},
                 {{"rca_peak_mb", "RCA (rca)", of_rca, std::nullopt, ""},
                  {"winding_peak_mb", "CWEIN (winding)", of_winding, std::nullopt, ""}});
}

std::optional<Plot> EnginePlots::stages(const std::string& name, const std::string& title,
                                        const std::string& engine) const {
  std::vector<Series> series = {
      {engine + "_arrangement", "arrangement", "#0072b2", std::nullopt, ""},
      {engine + "_hole_test", "hole test", "#d55e00", std::nullopt, ""},
      {engine + "_degenerate", "degenerate", "#009e73", std::nullopt, ""},
      {engine + "_cycles", "cycles", "#cc79a7", std::nullopt, ""},
      {engine + "_output", "output", "#999999", std::nullopt, ""},
  };
  // The other engine has its own tree only if low-dimensional features ask for one.
  if (engine == "rca")
    series.push_back({engine + "_hierarchy", "hierarchy", "#e69f00", std::nullopt, ""});
  return plot_of(name, csv, table, {title, "m", vertices_of_p, "seconds"}, series);
}

std::optional<Plot> EnginePlots::ratio(const std::string& name, const std::string& title) const {
  return plot_of(name, csv, table, {title, "m", vertices_of_p, "time of rca / time of winding"},
                 {{"ratio", "without output", of_rca, std::nullopt, ""},
                  {"ratio_with_output", "with output", of_winding, std::nullopt, ""}});
}

}  // namespace oplus
