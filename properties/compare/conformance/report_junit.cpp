// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "properties/compare/conformance/report.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

namespace {

/// Text in XML 1.0, which has no form at all for most control characters.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20 && c != '\n')
      result += '?';
    else
      result += c;
  }
  return result;
}

bool asked_nothing(const ConformanceTally& tally) {
  return tally.failures() == 0 && tally.count(Ruling::passed) == 0;
}

/// Tests, failures and skipped tests of some groups.
struct Counts {
  std::size_t tests = 0, failures = 0, skipped = 0;

  void add(const ConformanceTally& tally) {
    ++tests;
    failures += tally.failures() > 0;
    skipped += asked_nothing(tally);
  }
  std::string attributes() const {
    return "tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) +
           "\" errors=\"0\" skipped=\"" + std::to_string(skipped) + "\"";
  }
};

std::string kinds_in_words(const ConformanceTally& tally) {
  std::string words;
  for (const auto& [kind, count] : tally.kinds)
    words += (words.empty() ? "" : ", ") + kind + " " + std::to_string(count) + " times";
  return words;
}

void test_case(std::ostream& out, const ConformanceReport& report, std::size_t index) {
  const TrialGroup& group = report.groups[index];
  const ConformanceTally& tally = report.tallies[index];
  out << "    <testcase classname=\"" << escaped(report.engine) << '.' << group.part << "\" name=\""
      << escaped(group.name) << '"';
  if (asked_nothing(tally)) {
    out << ">\n      <skipped message=\"" << tally.count(Ruling::not_taken) << " not taken, "
        << tally.count(Ruling::skipped) << " skipped\"/>\n    </testcase>\n";
    return;
  }
  if (tally.failures() == 0) {
    out << "/>\n";
    return;
  }
  out << ">\n      <failure type=\"" << escaped(tally.kinds.begin()->first) << "\" message=\""
      << escaped(kinds_in_words(tally)) << "\">";
  for (const auto& [kind, count] : tally.kinds) {
    const ShrunkFailure& of = report.counterexamples.at(kind);
    out << escaped(kind + ": " + of.seen.failure.what + "\n" + replay_line(report, of) + "\n");
  }
  out << "</failure>\n    </testcase>\n";
}

}  // namespace

std::string to_junit(const ConformanceReport& report) {
  Counts all;
  for (const ConformanceTally& tally : report.tallies) all.add(tally);
  std::ostringstream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"conformance of "
      << escaped(report.engine) << "\" " << all.attributes() << ">\n";
  for (std::size_t first = 0; first < report.groups.size();) {
    std::size_t last = first;
    Counts counts;
    for (; last < report.groups.size() && report.groups[last].part == report.groups[first].part;
         ++last)
      counts.add(report.tallies[last]);
    out << "  <testsuite name=\"" << report.groups[first].part << "\" " << counts.attributes()
        << ">\n";
    for (; first < last; ++first) test_case(out, report, first);
    out << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
  return out.str();
}

}  // namespace oplus
