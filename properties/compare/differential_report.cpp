// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/differential_report.hpp"

#include <cctype>
#include <filesystem>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "checked/engines.hpp"
#include "properties/compare/sealed_report.hpp"
#include "properties/runner/finding.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/written.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

namespace {

std::string description(const MinkowskiSum& sum) {
  const auto count = [](std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  };
  return count(sum.outer.size(), "outer chain", "outer chains") + ", " +
         count(sum.holes.size(), "hole", "holes") + ", " +
         count(sum.dangling_edges.size(), "dangling edge", "dangling edges") + ", " +
         count(sum.isolated_vertices.size(), "isolated vertex", "isolated vertices") + ", area " +
         to_string(area(sum));
}

nlohmann::json to_json(const Tally& tally) {
  return {{"ran", tally.ran},
          {"skipped", tally.skipped},
          {"disagreed", tally.disagreed},
          {"holes_in_sum", tally.holes_in_sum},
          {"holes_in_summand", tally.holes_in_summand},
          {"low_dimensional_features", tally.low_dimensional_features},
          {"overlapping_segments", tally.overlapping_segments},
          {"several_components", tally.several_components},
          {"face_probes", tally.probes.faces},
          {"point_probes", tally.probes.points},
          {"not_taken", tally.not_taken}};
}

/// Engines that are not among the default ones must be named. In quotes for a shell.
std::string engine_option(const std::string& name) {
  if (name == "oracle" || find_engine(engines(), name) != nullptr) return "";
  std::string quoted;
  for (const char c : name) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return " --engine '" + quoted + "'";
}

/// A line for each reason and the first case that has it.
void write_skipped(std::ostream& out, const std::vector<SkippedCase>& skipped) {
  std::map<std::string, std::size_t> times;
  for (const SkippedCase& one : skipped) ++times[one.why];
  for (const auto& [index, name, why] : skipped) {
    std::size_t& left = times[why];
    if (left == 0) continue;
    out << "skipped: " << name;
    if (left > 1) out << " and " << left - 1 << " more";
    out << ": " << why << '\n';
    left = 0;
  }
}

std::string without_folder(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// "exec:./mine {p}" would name folders, and wants quotes in a shell.
std::string file_name(std::string engine) {
  for (char& c : engine)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  return engine.substr(0, 40);
}

std::string picture(const ShrunkDisagreement& shrunk) {
  const auto& [summands, found] = shrunk;
  std::vector<Panel> panels = panels_of(summands.p, summands.q);
  const auto add = [&](const std::string& title, const MinkowskiSum& sum) {
    std::vector<Layer> layers = layers_of(sum);
    if (found.witness) layers.push_back({style::difference, {}, {}, {*found.witness}});
    panels.push_back({title, std::move(layers)});
  };
  add("oracle", found.by_oracle);
  if (found.by_implementation) add(found.implementation, *found.by_implementation);
  return svg(panels);
}

}  // namespace

void Tally::add(const DifferentialResult& result) {
  for (const NotTakenSum& sum : result.not_taken)
    ++not_taken[sum.implementation + ", " + name(sum.boundary) + ": " + sum.why];
  if (result.kind == DifferentialResult::Kind::skipped) {
    ++skipped;
    return;
  }
  ++ran;
  disagreed += result.kind == DifferentialResult::Kind::disagreed;
  holes_in_sum += result.holes_in_sum;
  holes_in_summand += result.holes_in_summand;
  low_dimensional_features += result.low_dimensional_features;
  overlapping_segments += result.overlapping_segments;
  several_components += result.several_components;
  probes += result.probes;
}

nlohmann::ordered_json to_json(const DifferentialReport& report) {
  nlohmann::json json = {{"seed", report.seed},
                         {"engines", report.implementations},
                         {"hole_test", report.hole_test.empty() ? "all" : report.hole_test},
                         {"all", to_json(report.all)},
                         {"groups", nlohmann::json::object()},
                         {"skipped", nlohmann::json::array()},
                         {"disagreements", nlohmann::json::array()}};
  for (const auto& [group, tally] : report.groups) json["groups"][group] = to_json(tally);
  for (const auto& [index, name, why] : report.skipped)
    json["skipped"].push_back({{"index", index}, {"case", name}, {"why", why}});
  for (const ReportedDisagreement& reported : report.disagreements) {
    const Disagreement& found = reported.shrunk.disagreement;
    nlohmann::json entry = {{"index", reported.index},
                            {"found_in", reported.found_in},
                            {"engine", found.implementation},
                            {"boundary", name(found.boundary)},
                            {"what", found.what},
                            {"p", without_folder(reported.p_file)},
                            {"q", without_folder(reported.q_file)},
                            {"picture", without_folder(reported.picture)},
                            {"oracle_sum", wkt(found.by_oracle)}};
    if (found.by_implementation) entry["engine_sum"] = wkt(*found.by_implementation);
    if (found.no_sum)
      entry["no_sum"] = {{"kind", name(found.no_sum->kind())}, {"site", found.no_sum->site()}};
    if (found.witness)
      entry["witness"] = {to_string(found.witness->x), to_string(found.witness->y)};
    json["disagreements"].push_back(std::move(entry));
  }
  nlohmann::ordered_json sealable = begun_report("diff", report.campaign, report.shard);
  for (const auto& [key, value] : json.items()) sealable[key] = value;
  return sealable;
}

std::string summary(const DifferentialReport& report) {
  std::ostringstream out;
  const auto cell = [&](const auto& value, int width) { out << std::setw(width) << value; };
  const auto row = [&](const std::string& name, const auto&... values) {
    out << std::left << std::setw(12) << name << std::right;
    (cell(values, 12), ...);
    out << '\n';
  };
  row("", "cases", "holes in", "holes in", "low-dim.", "overlapping", "several", "disagree");
  row("", "run", "the sum", "a summand", "features", "segments", "components", "");
  const auto tally_row = [&](const std::string& name, const Tally& t) {
    row(name, t.ran, t.holes_in_sum, t.holes_in_summand, t.low_dimensional_features,
        t.overlapping_segments, t.several_components, t.disagreed);
  };
  for (const auto& [group, tally] : report.groups) tally_row(group, tally);
  tally_row("all", report.all);
  write_skipped(out, report.skipped);
  const Probes& probes = report.all.probes;
  if (report.hole_test.empty())
    out << "all hole tests gave the same answer " << probes.faces << " times about a face, "
        << probes.points << " times about a point\n";
  else
    out << "the hole test " << report.hole_test << " was asked " << probes.faces
        << " times about a face, " << probes.points << " times about a point\n";
  std::size_t not_taken = 0;
  for (const auto& [what, times] : report.all.not_taken) {
    out << counted(times, "sum", "sums") << " not taken by " << what << '\n';
    not_taken += times;
  }
  out << report.all.ran << " cases run, each closed and open";
  if (not_taken > 0) out << " but for " << counted(not_taken, "sum", "sums") << " not taken";
  out << ", " << report.all.skipped << " skipped, " << report.all.disagreed
      << " with a disagreement\n";
  return out.str();
}

ReportedDisagreement write_disagreement(const std::string& folder, const std::string& found_in,
                                        const ShrunkDisagreement& shrunk) {
  const Finding files = write_finding(
      folder, "diff-" + file_name(shrunk.disagreement.implementation), shrunk.summands);
  std::string picture_file = files.p.string();
  picture_file.replace(picture_file.rfind("-p.dat"), std::string::npos, ".svg");
  write_file(picture_file, picture(shrunk));
  return {0, found_in, shrunk, files.p.string(), files.q.string(), picture_file};
}

std::string explanation(const ReportedDisagreement& reported) {
  const Disagreement& found = reported.shrunk.disagreement;
  std::ostringstream out;
  out << "disagreement on the " << name(found.boundary) << " sum, found in " << reported.found_in
      << ", shrunk to " << vertex_count(reported.shrunk.summands.p) << " and "
      << vertex_count(reported.shrunk.summands.q) << " vertices\n"
      << "  the first is the oracle: " << description(found.by_oracle) << '\n';
  out << "  the second is " << found.implementation << ": "
      << (found.by_implementation ? description(*found.by_implementation) : "no sum") << '\n'
      << "  " << found.what << '\n';
  if (found.witness) out << "  they differ at " << to_string(*found.witness) << '\n';
  out << "  picture: " << reported.picture << '\n'
      << "  see it again: oplus-check diff --pair " << reported.p_file << ' ' << reported.q_file
      << engine_option(found.implementation) << '\n';
  return out.str();
}

}  // namespace oplus
