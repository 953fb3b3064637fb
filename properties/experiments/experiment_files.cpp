// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/experiment_files.hpp"

#include <cstdlib>
#include <fstream>
#include <thread>

#include "properties/experiments/process_of_its_own.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string page(const ExperimentResult& result) {
  std::string text = "# " + result.title + "\n";
  for (const ShownTable& shown : result.shown)
    text += '\n' + shown.text + "\n\n" + to_markdown(result.table, shown.columns);
  return text;
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  const std::string key = "model name";
  for (std::string line; std::getline(info, line);)
    if (line.starts_with(key)) return line.substr(line.find(':') + 2);
  return "an unknown processor";
}

}  // namespace

void write_experiment(const std::filesystem::path& folder, const Experiment& experiment,
                      const ExperimentResult& result) {
  write_file((folder / (experiment.name + ".csv")).string(), to_csv(result.table));
  write_file((folder / (experiment.name + ".md")).string(), page(result));
  for (const Plot& plot : result.plots)
    write_file((folder / (plot.name + ".gp")).string(), to_gnuplot(plot));
}

std::string index_entry(const Experiment& experiment, const ExperimentResult& result) {
  std::string text = "\n## " + experiment.name + "\n" + experiment.what + ". [Table](" +
                     experiment.name + ".md), [CSV](" + experiment.name + ".csv)\n\n";
  for (const std::string& line : result.summary) text += "- " + line + '\n';
  for (const std::string& line : result.wrong) text += "- **wrong:** " + line + '\n';
  for (const Plot& plot : result.plots) text += "\n![" + plot.name + "](" + plot.name + ".svg)\n";
  return text;
}

std::string index_head(const ExperimentSettings& settings) {
  double load[1] = {0};
  const bool has_load = ::getloadavg(load, 1) == 1;
  const ProcessReport nothing =
      in_process_of_its_own([] { return std::string(); }, settings.memory_limit_mb);
  return "# Experiments\n\nWritten by `oplus-check experiments`, seed " +
         std::to_string(settings.seed) + ", scale " + shown(settings.scale) + ". One thread on " +
         processor() + " (" + std::to_string(std::thread::hardware_concurrency()) + " at a time)" +
         (has_load ? ", load " + shown(load[0]) + " before the run" : "") +
         ". A process that measures nothing has a peak of " + shown(nothing.peak_mb) +
         " MB resident.\n";
}

}  // namespace oplus
