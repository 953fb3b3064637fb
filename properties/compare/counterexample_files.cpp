// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/counterexample_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "properties/compare/operation.hpp"
#include "properties/runner/finding.hpp"
#include "reference/chains/frame.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/writing.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

namespace {

/// "crashed: SIGSEGV" becomes "crashed-sigsegv".
std::string slug(const std::string& kind) {
  std::string result;
  for (const char c : kind.substr(0, 48)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!result.empty() && result.back() != '-')
      result += '-';
  }
  while (!result.empty() && result.back() == '-') result.pop_back();
  return result;
}

std::string picture(const WrongSum& sum, const std::string& judge) {
  std::vector<Panel> panels = panels_of(framed(sum.pair.p, 1), framed(sum.pair.q, 1));
  const auto add = [&](const std::string& title, const PlanarSet& value) {
    PlanarSet drawn = canonical_sum(framed(region_of(value), 1));
    drawn.dangling_edges = value.dangling_edges;
    drawn.isolated_vertices = value.isolated_vertices;
    std::vector<Layer> layers = layers_of(drawn);
    if (sum.failure.witness) layers.push_back({style::difference, {}, {}, {*sum.failure.witness}});
    panels.push_back({title, std::move(layers)});
  };
  if (sum.right) add(judge, *sum.right);
  // Only a region can be filled.
  if (sum.given && !malformed(*sum.given)) add(sum.engine, *sum.given);
  return svg(panels);
}

}  // namespace

std::vector<std::string> CounterexampleFiles::all() const {
  std::vector<std::string> names = {p, q, right, given, picture};
  std::erase(names, "");
  return names;
}

CounterexampleFiles files_of(const ShrunkFailure& found) {
  const auto& [p, q] = found.sum.pair;
  std::ostringstream out;
  out << slug(found.sum.failure.kind) << '-' << std::hex << std::setfill('0') << std::setw(16)
      << seed_of(found.sum.engine + written(p, Format::dat) + written(q, Format::dat), 0);
  const std::string name = out.str();
  CounterexampleFiles files{name + "-p.dat", name + "-q.dat", name + ".svg"};
  if (found.sum.right && can_hold(Format::wkt, *found.sum.right)) files.right = name + "-right.wkt";
  if (found.sum.given && !malformed(*found.sum.given) && can_hold(Format::wkt, *found.sum.given))
    files.given = name + "-given.wkt";
  return files;
}

void write_counterexamples(const CampaignReport& report) {
  if (report.counterexamples.empty()) return;
  std::filesystem::create_directories(report.out);
  for (const auto& [kind, found] : report.counterexamples) {
    const CounterexampleFiles files = files_of(found);
    const auto put = [&](const std::string& name, const std::string& content) {
      write_file((std::filesystem::path(report.out) / name).string(), content);
    };
    put(files.p, written(found.sum.pair.p, Format::dat));
    put(files.q, written(found.sum.pair.q, Format::dat));
    if (!files.right.empty()) put(files.right, written(*found.sum.right, Format::wkt));
    if (!files.given.empty()) put(files.given, written(*found.sum.given, Format::wkt));
    put(files.picture, picture(found.sum, report.campaign.judge));
  }
}

std::string replay_line(const CampaignReport& report, const ShrunkFailure& found) {
  const CounterexampleFiles files = files_of(found);
  const auto file = [&](const std::string& name) {
    return " " + for_shell((std::filesystem::path(report.out) / name).string());
  };
  std::string line =
      "oplus-check " + std::string(report.report == "conformance" ? "conformance" : "diff");
  // Where the judge threw, any engine will do.
  if (found.sum.engine != report.campaign.judge)
    line += " --engine " + for_shell(found.sum.engine);
  else if (report.report == "conformance")
    line += " --engine slide";
  const Campaign defaults, &campaign = report.campaign;
  std::ostringstream options;
  if (campaign.hole_test != defaults.hole_test)
    options << " --collision-test " << campaign.hole_test;
  if (!campaign.is_of_sums()) options << " --operation " << campaign.operation;
  if (campaign.judge != defaults.judge) options << " --judge " << campaign.judge;
  if (campaign.largest != default_largest(campaign)) options << " --largest " << campaign.largest;
  if (campaign.time_limit != defaults.time_limit)
    options << " --time-limit " << campaign.time_limit;
  if (campaign.memory_limit != defaults.memory_limit)
    options << " --memory-limit " << campaign.memory_limit;
  return line + options.str() + " --pair" + file(files.p) + file(files.q);
}

}  // namespace oplus
