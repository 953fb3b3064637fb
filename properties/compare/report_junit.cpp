// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "properties/compare/counterexample_files.hpp"
#include "properties/compare/report_text.hpp"
#include "properties/compare/sum_digest.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

using Element = boost::property_tree::ptree;

/// XML 1.0 cannot express most control characters.
void put(Element& element, const std::string& attribute, std::string value) {
  std::ranges::replace_if(
      value, [](unsigned char c) { return c < 0x20; }, '?');
  element.put("<xmlattr>." + attribute, value);
}

/// A suite, or all of them; a source is a test.
Element suite(const std::string& name, const std::vector<CountedSource>& sources) {
  Element element;
  const auto put_count = [&](const std::string& attribute, const auto& is_counted) {
    put(element, attribute, std::to_string(std::ranges::count_if(sources, is_counted)));
  };
  put(element, "name", name);
  put(element, "tests", std::to_string(sources.size()));
  put_count("failures", [](const CountedSource& s) { return s.counts.disagreed > 0; });
  put(element, "errors", "0");
  put_count("skipped", [](const CountedSource& s) { return s.counts.ran == 0; });
  return element;
}

Element test_case(const CampaignReport& report, const CountedSource& source) {
  const Tally& counts = source.counts;
  Element element;
  put(element, "classname", engines_in_words(report) + "." + source.part);
  put(element, "name", source.name);
  if (counts.ran == 0)
    put(element.add_child("skipped", {}), "message",
        counts.pairs == 0
            ? report.interruption()
            : std::to_string(counts.count("open unsupported")) + " open sums unsupported, " +
                  std::to_string(counts.count("refused")) + " refused, " +
                  std::to_string(counts.count("skipped")) + " skipped");
  if (counts.kinds.empty()) return element;
  std::string kinds, lines;
  for (const auto& [kind, times] : counts.kinds) {
    kinds += (kinds.empty() ? "" : ", ") + kind + ": " + counted(times, "sum", "sums");
    const FirstFailure& first = source.first_failures.at(kind);
    lines += kind + ": " + first.what + "\nfirst found in " + first.found_in + "\nP " +
             in_words(first.pair.p) + "Q " + in_words(first.pair.q);
    if (const auto of = report.counterexamples.find(kind); of != report.counterexamples.end())
      lines +=
          "shrunk, from " + of->second.found_in + ": " + replay_line(report, of->second) + "\n";
  }
  Element& failure = element.add_child("failure", Element(lines));
  put(failure, "type", counts.kinds.begin()->first);
  put(failure, "message", kinds);
  return element;
}

}  // namespace

std::string to_junit(const CampaignReport& report) {
  Element all = suite(report.report + " of " + engines_in_words(report), report.sources);
  for (const CountedPart& part : parts_of(report)) {
    Element& suite_of_part = all.add_child("testsuite", suite(part.part, part.sources));
    for (const CountedSource& source : part.sources)
      suite_of_part.add_child("testcase", test_case(report, source));
  }
  Element document;
  document.add_child("testsuites", all);
  std::ostringstream out;
  write_xml(out, document, boost::property_tree::xml_writer_make_settings<std::string>(' ', 2));
  return out.str();
}

}  // namespace oplus
