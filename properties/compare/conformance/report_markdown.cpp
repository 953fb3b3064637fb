// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "checked/cli/version.hpp"
#include "properties/compare/conformance/report.hpp"
#include "properties/compare/sealed_report.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/written.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

namespace {

/// Text as a cell of a table: no bar ends it, no name is taken for markup.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '\\' || c == '<' || c == '*' || c == '`') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

void head(std::ostream& out, const std::vector<std::string>& first) {
  for (const std::string& column : first) out << "| " << column << ' ';
  out << "| pairs ";
  for (const auto& [ruling, name] : rulings()) out << "| " << name << ' ';
  out << "|\n";
  for (std::size_t i = 0; i < first.size(); ++i) out << "|---";
  for (std::size_t i = 0; i < rulings().size() + 1; ++i) out << "|--:";
  out << "|\n";
}

void row(std::ostream& out, const std::vector<std::string>& first, const ConformanceTally& tally) {
  for (const std::string& column : first) out << "| " << cell(column) << ' ';
  out << "| " << tally.pairs << ' ';
  for (const auto& [ruling, name] : rulings()) out << "| " << tally.count(ruling) << ' ';
  out << "|\n";
}

std::string in_words(const MinkowskiSum& sum) {
  if (!malformed(sum)) return written(sum, Format::wkt);
  std::string text;
  for (const std::vector<Chain>* chains : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *chains) {
      text += chains == &sum.outer ? "outer chain" : "hole";
      for (const Point& p : chain) text += " " + to_string(p);
      text += "\n";
    }
  }
  return text;
}

void counterexample(std::ostream& out, const ConformanceReport& report, const ShrunkFailure& of,
                    std::size_t times) {
  const SeenFailure& seen = of.seen;
  const CounterexampleFiles files = files_of(of);
  out << "\n### " << cell(seen.failure.kind) << "\n\n"
      << counted(times, "sum", "sums") << ". The smallest pair was found in " << cell(of.group)
      << ", " << cell(of.found_in) << ", with " << of.found_size.vertices << " vertices; it is "
      << (!of.is_repeatable ? "not shrunk, since it was not seen when asked again"
          : of.is_shrunk    ? "shrunk to " + std::to_string(size_of(seen.summands).vertices)
                            : "at " + std::to_string(size_of(seen.summands).vertices) +
                               " where the tries were used up")
      << " (" << counted(of.tries, "pair", "pairs") << " tried). The " << name(seen.boundary)
      << " sum";
  if (!seen.failure.what.empty()) out << ": " << cell(seen.failure.what);
  if (seen.right && seen.given) out << ", the first being the oracle's";
  if (seen.failure.witness) out << ", at " << to_string(*seen.failure.witness);
  if (seen.failure.squared_distance)
    out << "; the boundaries differ by " << distance_in_words(*seen.failure.squared_distance);
  out << ".\n\n```text\nP      " << written(seen.summands.p, Format::wkt) << "Q      "
      << written(seen.summands.q, Format::wkt);
  if (seen.right) out << "oracle " << in_words(*seen.right);
  if (seen.given) out << "engine " << in_words(*seen.given);
  out << "```\n\n![both summands, their convolution, and the sums](" << files.picture
      << ")\n\n```sh\n"
      << replay_line(report, of) << "\n```\n";
}

}  // namespace

std::string to_markdown(const ConformanceReport& report) {
  const ConformanceTally all = report.all();
  const ConformanceSettings& settings = report.settings;
  std::ostringstream out;
  out << "# Conformance of " << cell(report.engine) << "\n\n"
      << (report.conforms() ? "**It conforms**: " : "**It does not conform**: ")
      << counted(all.count(Ruling::passed), "sum", "sums") << " passed, "
      << counted(all.failures(), "failure", "failures") << " of "
      << counted(all.kinds.size(), "kind", "kinds") << ", " << all.count(Ruling::not_taken)
      << " not taken, " << all.count(Ruling::skipped) << " skipped.\n\n";
  if (report.pairs.empty()) {
    out << "Oplus " << version << ", seed " << settings.seed << ", ";
    if (settings.cases)
      out << counted(*settings.cases, "pair", "pairs") << " a group";
    else
      out << "a budget of " << counted(settings.budget, "pair", "pairs");
  } else {
    out << "Oplus " << version << ", " << counted(report.pairs.size(), "given pair", "given pairs");
  }
  if (settings.shard.of > 1)
    out << ", shard " << settings.shard.index << " of " << settings.shard.of;
  out << ". Sums are counted, a closed and an open one for each pair.\n\n## Parts\n\n";
  head(out, {"part"});
  std::vector<std::string> parts;
  for (const TrialGroup& group : report.groups)
    if (parts.empty() || parts.back() != group.part) parts.push_back(group.part);
  for (const std::string& part : parts) {
    ConformanceTally tally;
    for (std::size_t i = 0; i < report.groups.size(); ++i)
      if (report.groups[i].part == part) tally += report.tallies[i];
    row(out, {part}, tally);
  }
  row(out, {"all"}, all);
  if (!report.conforms()) {
    out << "\n## Kinds of failure\n\n| kind | sums | vertices of the smallest pair |\n|---|--:|--:|\n";
    for (const auto& [kind, times] : all.kinds)
      out << "| " << cell(kind) << " | " << times << " | "
          << size_of(report.counterexamples.at(kind).seen.summands).vertices << " |\n";
    for (const auto& [kind, times] : all.kinds)
      counterexample(out, report, report.counterexamples.at(kind), times);
  }
  out << "\n## Groups\n\n";
  head(out, {"part", "group"});
  for (std::size_t i = 0; i < report.groups.size(); ++i)
    row(out, {report.groups[i].part, report.groups[i].name}, report.tallies[i]);
  return out.str();
}

}  // namespace oplus
