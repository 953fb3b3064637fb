// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/experiment_files.hpp"

#include <algorithm>
#include <cstdlib>

#include "properties/runner/child_process.hpp"
#include "reference/io/writing.hpp"
#include "tests/bench/numbers.hpp"
#include "tests/bench/own_process.hpp"
#include "tests/bench/report.hpp"

namespace oplus {

namespace {

bool is_drawn(const Plot& plot, const Rows& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const Row* row) {
    return row->number(plot.needs) &&
           (plot.family.empty() || row->words.at("family") == plot.family);
  });
}

/// As gnuplot reads it; NaN draws nothing.
std::string curve(const Experiment& experiment, const Rows& rows, const std::string& y) {
  if (experiment.fitting == nullptr) return "NaN";
  const auto [xs, ys] = points(rows, experiment.fitted_over, y);
  const std::optional<Fit> fit = experiment.fitting(xs, ys);
  return fit ? formula(*fit) : "NaN";
}

}  // namespace

PageData write_experiment(const std::filesystem::path& folder, const Experiment& experiment,
                          const Rows& rows, const std::vector<std::string>& faults,
                          std::vector<std::string>& plots) {
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file((folder / name).string(), text);
  };
  write(experiment.name + ".csv", to_csv(rows, experiment.first_columns));

  write(experiment.name + ".md",
        rendered(experiment.name + ".md.mustache", PageData("table", table_section(rows))));

  std::vector<std::string> drawn;
  for (const Plot& plot : experiment.plots) {
    if (!is_drawn(plot, rows)) continue;
    PageData data("name", plot.name);
    data.set("rca_curve", curve(experiment, rows, "rca.time"));
    data.set("winding_curve", curve(experiment, rows, "winding.time"));
    write(plot.name + ".gp", rendered(plot.name + ".gp.mustache", data));
    drawn.push_back(plot.name);
  }
  plots.insert(plots.end(), drawn.begin(), drawn.end());

  PageData entry("name", experiment.name);
  entry.set("what", experiment.what);
  entry.set("summary", page_data(experiment.summary(rows)));
  entry.set("wrong", page_data(faults));
  entry.set("plots", page_data(drawn));
  return entry;
}

void write_index(const std::filesystem::path& folder, const ExperimentSettings& settings,
                 const PageData& experiments) {
  const Measurement nothing =
      measured_in_own_process([](const auto&) { return Measurement{}; }, MeasuringLimits{});
  double load[1] = {0};
  const bool has_load = ::getloadavg(load, 1) == 1;
  const Setting setting = this_setting("", 0);
  PageData index("seed", std::to_string(settings.seed));
  index.set("scale", three_digits(settings.scale));
  index.set("commit", setting.commit);
  index.set("processor", setting.processor);
  index.set("cores", std::to_string(setting.cores));
  index.set("load", has_load ? three_digits(load[0]) : "unknown");
  index.set("peak_mb", three_digits(nothing.numbers.at("peak_mb")));
  index.set("experiments", experiments);
  write_file((folder / "index.md").string(), rendered("experiments.md.mustache", index));
}

Drawn draw(const std::filesystem::path& folder, const std::string& plot) {
  constexpr int exit_not_found = 127;
  const std::string script =
      "command -v gnuplot >/dev/null || exit 127; cd \"$1\" && exec gnuplot \"$2\"";
  const EndedProcess ended =
      run_program({"/bin/sh", "-c", script, "sh", folder.string(), plot + ".gp"}, {});
  if (ended.how != EndedProcess::How::exited || ended.code != 0)
    return ended.code == exit_not_found ? Drawn::no_gnuplot : Drawn::failed;
  return Drawn::drawn;
}

}  // namespace oplus
