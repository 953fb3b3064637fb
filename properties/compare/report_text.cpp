// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/report_text.hpp"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "properties/compare/counterexample_files.hpp"
#include "properties/compare/operation.hpp"
#include "properties/compare/report_json.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string description(const PlanarSet& sum) {
  return counted(sum.outer.size(), "outer chain", "outer chains") + ", " +
         counted(sum.holes.size(), "hole", "holes") + ", " +
         counted(sum.dangling_edges.size(), "dangling edge", "dangling edges") + ", " +
         counted(sum.isolated_vertices.size(), "isolated vertex", "isolated vertices") +
         (sum.is_unbounded ? ", unbounded" : ", area " + to_string(area(sum)));
}

/// What the pairs of `diff` had, by family: of an operation, what its values have.
void write_classes(std::ostream& out, const CampaignReport& report) {
  const auto row = [&](const std::string& name, const auto&... values) {
    out << std::left << std::setw(12) << name << std::right;
    ((out << std::setw(12) << values), ...);
    out << '\n';
  };
  const bool is_of_sums = report.campaign.is_of_sums();
  if (is_of_sums) {
    row("", "cases", "holes in", "holes in", "low-dim.", "overlapping", "several", "disagree");
    row("", "run", "the sum", "a summand", "features", "segments", "components");
  } else {
    row("", "cases", "value", "value", "value with", "value with", "value", "disagree");
    row("", "run", "unbounded", "with area", "edges", "points", "empty");
  }
  const auto tally_row = [&](const std::string& name, const Tally& t) {
    if (is_of_sums) {
      row(name, t.ran, t.holes_in_sum, t.holes_in_summand, t.low_dimensional_features,
          t.overlapping_segments, t.several_components, t.disagreed);
      return;
    }
    const auto of = [&](const std::string& part) {
      const auto counted = t.values.find(part);
      return counted == t.values.end() ? 0 : counted->second;
    };
    row(name, t.ran, of("unbounded"), of("area"), of("edges"), of("points"), of("empty"),
        t.disagreed);
  };
  std::map<std::string, Tally> by_name;
  for (const CountedSource& source : report.sources) by_name[source.name] += source.counts;
  for (const auto& [name, tally] : by_name) tally_row(name, tally);
  tally_row("all", report.all());
}

/// A line for each reason and the first case that has it.
void write_skipped(std::ostream& out, const CampaignReport& report) {
  std::map<std::size_t, std::pair<std::string, const SkippedPairs*>> in_order;
  for (const auto& [why, pairs] : report.skipped) in_order[pairs.index] = {why, &pairs};
  for (const auto& [index, skipped] : in_order) {
    const auto& [why, pairs] = skipped;
    out << "skipped: " << pairs->first;
    if (pairs->times > 1) out << " and " << pairs->times - 1 << " more";
    out << ": " << why << '\n';
  }
}

/// The start of a line.
std::string interruption(const CampaignReport& report) {
  return report.is_interrupted() ? report.interruption() + ": " : "";
}

std::string summary_of_diff(const CampaignReport& report) {
  std::ostringstream out;
  write_classes(out, report);
  write_skipped(out, report);
  const Tally all = report.all();
  const std::string& hole_test = report.campaign.hole_test;
  out << (hole_test == "all" ? "all hole tests gave the same answer "
                             : "the hole test " + hole_test + " was asked ")
      << all.face_probes << " times about a face, " << all.point_probes << " times about a point\n";
  for (const auto& [engine, times] : all.open_unsupported)
    out << engine << " computes closed sums only: " << counted(times, "open sum", "open sums")
        << " not compared, which is no failure\n";
  for (const auto& [what, times] : all.refused)
    out << counted(times, "sum", "sums") << " refused by " << what << '\n';
  out << interruption(report) << counted(all.ran, "case", "cases") << " run, "
      << (report.campaign.is_of_sums() ? "each closed and open"
                                       : "one value of " + report.campaign.operation + " each");
  const std::size_t open = all.count("open unsupported"), refused = all.count("refused");
  if (open > 0) out << ", " << counted(open, "open sum", "open sums") << " unsupported";
  if (refused > 0) out << ", " << counted(refused, "sum", "sums") << " refused";
  out << ", " << all.skipped << " skipped, " << all.disagreed << " with a disagreement\n";
  return out.str();
}

std::string summary_of_exhaustive(const CampaignReport& report) {
  std::ostringstream out;
  const Tally all = report.all();
  out << report.sources.at(0).name << "; shard " << report.shard.index << " of " << report.shard.of
      << ": " << report.done << " of " << counted(report.pairs, "pair", "pairs") << '\n'
      << "with holes in the sum " << all.holes_in_sum << ", with low-dimensional features "
      << all.low_dimensional_features << ", with overlapping segments " << all.overlapping_segments
      << '\n'
      << "digest of all sums " << report.digest.to_string() << '\n'
      << interruption(report) << counted(report.done, "pair", "pairs")
      << " compared, closed and open, " << all.disagreed << " with a disagreement\n";
  return out.str();
}

std::string summary_of_conformance(const CampaignReport& report) {
  std::ostringstream out;
  const auto cell = [&](const std::string& word, const auto& value) {
    out << std::setw(static_cast<int>(std::max<std::size_t>(word.size(), 6)) + 2) << value;
  };
  out << std::setw(20) << "pairs";
  for (const std::string& ruling : rulings()) cell(ruling, ruling);
  out << '\n';
  const auto row = [&](const std::string& name, const Tally& tally) {
    out << std::left << std::setw(12) << name << std::right << std::setw(8) << tally.pairs;
    for (const std::string& ruling : rulings()) cell(ruling, tally.count(ruling));
    out << '\n';
  };
  for (const CountedPart& part : parts_of(report)) row(part.part, part.all);
  const Tally all = report.all();
  row("all", all);
  out << engines_in_words(report) << ' ' << report.verdict() << ": "
      << counted(all.count("passed"), "sum", "sums") << " passed, "
      << counted(all.failures(), "failure", "failures") << " of "
      << counted(all.kinds.size(), "kind", "kinds") << '\n';
  return out.str();
}

}  // namespace

std::string summary(const CampaignReport& report) {
  return "compared with " + judge_in_words(report.campaign) + ":\n" +
         (report.report == "exhaustive"    ? summary_of_exhaustive(report)
          : report.report == "conformance" ? summary_of_conformance(report)
                                           : summary_of_diff(report));
}

std::string explanation(const CampaignReport& report, const ShrunkFailure& found) {
  const auto& [engine, boundary, failure, pair, right, given] = found.sum;
  std::ostringstream out;
  const Campaign& campaign = report.campaign;
  out << "disagreement on "
      << (campaign.is_of_sums() ? "the " + name(boundary) + " sum" : campaign.operation)
      << ", found in " << found.found_in << ", shrunk to " << vertex_count(pair.p) << " and "
      << vertex_count(pair.q) << " vertices: " << failure.kind << '\n';
  if (!found.is_repeatable)
    out << "  not repeatable: it did not fail in this way when asked again, so it is not shrunk\n";
  else if (!found.is_shrunk)
    out << "  there may be a smaller pair: " << found.tries << " were tried\n";
  if (right)
    out << "  the first is " << judge_in_words(campaign) << ": " << description(*right) << '\n';
  out << "  the second is " << engine << ": " << (given ? description(*given) : "no sum") << '\n';
  if (!failure.what.empty()) out << "  " << failure.what << '\n';
  if (failure.witness) out << "  they differ at " << to_string(*failure.witness) << '\n';
  if (failure.squared_distance)
    out << "  their boundaries are about " << std::setprecision(3)
        << std::sqrt(failure.squared_distance->get_d()) << " apart\n";
  out << "  picture: " << (std::filesystem::path(report.out) / files_of(found).picture).string()
      << '\n'
      << "  reproduce: " << replay_line(report, found) << '\n';
  return out.str();
}

std::string report_text(const CampaignReport& report, const std::string& file) {
  if (file.ends_with(".md"))
    return to_markdown(report, std::filesystem::path(file).parent_path().string());
  return file.ends_with(".xml") ? to_junit(report) : sealed(report);
}

bool is_report_name(const std::string& file) {
  return file == "-" || file.ends_with(".md") || file.ends_with(".xml") || file.ends_with(".json");
}

std::vector<CountedPart> parts_of(const CampaignReport& report) {
  std::vector<CountedPart> parts;
  for (const CountedSource& source : report.sources) {
    if (parts.empty() || parts.back().part != source.part) parts.push_back({source.part, {}});
    parts.back().sources.push_back(source);
    parts.back().all += source.counts;
  }
  return parts;
}

std::string engines_in_words(const CampaignReport& report) {
  return boost::join(report.campaign.engines, ", ");
}

}  // namespace oplus
