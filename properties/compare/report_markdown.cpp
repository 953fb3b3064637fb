// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <sstream>

#include "properties/compare/counterexample_files.hpp"
#include "properties/compare/operation.hpp"
#include "properties/compare/report_text.hpp"
#include "properties/compare/sum_digest.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

/// Text as a cell of a table, with the characters of Markdown quoted.
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
  for (const std::string& ruling : rulings()) out << "| " << ruling << ' ';
  out << "|\n";
  for (std::size_t i = 0; i < first.size(); ++i) out << "|---";
  for (std::size_t i = 0; i < rulings().size() + 1; ++i) out << "|--:";
  out << "|\n";
}

void row(std::ostream& out, const std::vector<std::string>& first, const Tally& tally) {
  for (const std::string& column : first) out << "| " << cell(column) << ' ';
  out << "| " << tally.pairs << ' ';
  for (const std::string& ruling : rulings()) out << "| " << tally.count(ruling) << ' ';
  out << "|\n";
}

/// Where a picture is, from the folder of the Markdown's file.
std::string link_to(const std::string& picture, const CampaignReport& report,
                    const std::string& folder) {
  const std::filesystem::path here = std::filesystem::current_path();
  return (here / report.out / picture)
      .lexically_normal()
      .lexically_proximate((here / folder / "").lexically_normal())
      .string();
}

void counterexample(std::ostream& out, const CampaignReport& report, const std::string& kind,
                    const ShrunkFailure& found, const std::string& folder) {
  const WrongSum& sum = found.sum;
  out << "\n### " << cell(kind) << "\n\n"
      << counted(report.all().kinds.at(kind), "sum", "sums") << ". The smallest pair was found in "
      << cell(found.source) << ", with " << found.found_size.vertices << " vertices.\n\n```text\n"
      << explanation(report, found) << "P      " << in_words(sum.pair.p) << "Q      "
      << in_words(sum.pair.q);
  if (sum.right) out << "judge  " << in_words(*sum.right);
  if (sum.given) out << "engine " << in_words(*sum.given);
  out << "```\n\n![both summands, their convolution, and the sums](<"
      << link_to(files_of(found).picture, report, folder) << ">)\n";
}

}  // namespace

std::string to_markdown(const CampaignReport& report, const std::string& folder) {
  const Tally all = report.all();
  const Campaign& campaign = report.campaign;
  std::ostringstream out;
  out << "# Conformance of " << cell(engines_in_words(report)) << "\n\n"
      << "**It " << report.verdict() << "**: " << counted(all.count("passed"), "sum", "sums")
      << " passed, " << counted(all.failures(), "failure", "failures") << " of "
      << counted(all.kinds.size(), "kind", "kinds") << ", "
      << counted(all.count("open unsupported"), "open sum", "open sums") << " unsupported, "
      << all.count("refused") << " refused, " << all.count("skipped") << " skipped.\n\nOplus "
      << report.version << ", ";
  if (campaign.pairs.empty())
    out << "seed " << campaign.seed << ", " << counted(report.pairs, "pair", "pairs");
  else
    out << counted(campaign.pairs.size(), "given pair", "given pairs");
  if (report.shard.of > 1) out << ", shard " << report.shard.index << " of " << report.shard.of;
  out << ". Compared with " << judge_in_words(campaign)
      << (campaign.is_of_sums()
              ? ". Two sums per pair are counted, the closed one and the open one. "
              : ". One value per pair is counted. ")
      << "Paths are from the folder "
         "in which the command was run.\n\n## Parts\n\n";
  head(out, {"part"});
  for (const CountedPart& part : parts_of(report)) row(out, {part.part}, part.all);
  row(out, {"all"}, all);
  if (!report.counterexamples.empty()) {
    out << "\n## Kinds of failure\n\n| kind | sums | vertices of the smallest pair |\n|---|--:|--:|\n";
    for (const auto& [kind, found] : report.counterexamples)
      out << "| " << cell(kind) << " | " << all.kinds.at(kind) << " | "
          << size_of(found.sum.pair).vertices << " |\n";
    for (const auto& [kind, found] : report.counterexamples)
      counterexample(out, report, kind, found, folder);
  }
  out << "\n## Sources\n\n";
  head(out, {"part", "source"});
  for (const CountedSource& source : report.sources)
    row(out, {source.part, source.name}, source.counts);
  return out.str();
}

}  // namespace oplus
