// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance/report.hpp"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "properties/compare/sealed_report.hpp"
#include "properties/runner/finding.hpp"
#include "properties/runner/property_run.hpp"
#include "reference/io/written.hpp"
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

std::string picture(const ShrunkFailure& counterexample, const std::string& engine) {
  const SeenFailure& seen = counterexample.seen;
  std::vector<Panel> panels = panels_of(seen.summands.p, seen.summands.q);
  const auto add = [&](const std::string& title, const MinkowskiSum& sum) {
    std::vector<Layer> layers = layers_of(sum);
    if (seen.failure.witness)
      layers.push_back({style::difference, {}, {}, {*seen.failure.witness}});
    panels.push_back({title, std::move(layers)});
  };
  if (seen.right) add("oracle", *seen.right);
  // Nothing that is no region can be filled.
  if (seen.given && !malformed(*seen.given)) add(engine, *seen.given);
  return svg(panels);
}

}  // namespace

std::size_t ConformanceTally::count(Ruling ruling) const {
  const auto found = rulings.find(ruling);
  return found == rulings.end() ? 0 : found->second;
}

std::size_t ConformanceTally::failures() const {
  std::size_t failures = 0;
  for (const auto& [kind, count] : kinds) failures += count;
  return failures;
}

ConformanceTally& ConformanceTally::operator+=(const ConformanceTally& more) {
  pairs += more.pairs;
  for (const auto& [ruling, count] : more.rulings) rulings[ruling] += count;
  for (const auto& [kind, count] : more.kinds) kinds[kind] += count;
  return *this;
}

ConformanceTally ConformanceReport::all() const {
  ConformanceTally sum;
  for (const ConformanceTally& tally : tallies) sum += tally;
  return sum;
}

bool is_better(const ShrunkFailure& first, const ShrunkFailure& second) {
  if (second.found_size < first.found_size) return true;
  return !(first.found_size < second.found_size) && second.index < first.index;
}

const std::vector<std::pair<Ruling, std::string>>& rulings() {
  static const std::vector<std::pair<Ruling, std::string>> all = {
      {Ruling::passed, "passed"},
      {Ruling::wrong, "wrong"},
      {Ruling::crashed, "crashed"},
      {Ruling::hung, "hung"},
      {Ruling::out_of_memory, "out of memory"},
      {Ruling::unreadable, "unreadable"},
      {Ruling::not_taken, "not taken"},
      {Ruling::skipped, "skipped"}};
  return all;
}

std::string distance_in_words(const Rational& squared) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", std::sqrt(squared.get_d()));
  return std::string("about ") + buffer;
}

std::string conformance_text(const ConformanceReport& report, const std::string& file) {
  if (file.ends_with(".md")) return to_markdown(report);
  if (file.ends_with(".xml")) return to_junit(report);
  return sealed(to_json(report));
}

bool is_report_name(const std::string& file) {
  return file.ends_with(".md") || file.ends_with(".xml") || file.ends_with(".json");
}

CounterexampleFiles files_of(const ShrunkFailure& counterexample) {
  const auto& [p, q] = counterexample.seen.summands;
  std::ostringstream name;
  name << slug(counterexample.seen.failure.kind) << '-' << std::hex << std::setfill('0')
       << std::setw(16) << seed_of(written(p, Format::dat) + written(q, Format::dat), 0);
  CounterexampleFiles files{name.str() + "-p.dat", name.str() + "-q.dat", "", "",
                            name.str() + ".svg"};
  if (counterexample.seen.right) files.right = name.str() + "-right.wkt";
  if (counterexample.seen.given && !malformed(*counterexample.seen.given))
    files.given = name.str() + "-given.wkt";
  return files;
}

void write_counterexamples(const ConformanceReport& report, const std::string& folder) {
  if (report.counterexamples.empty()) return;
  std::filesystem::create_directories(folder);
  for (const auto& [kind, counterexample] : report.counterexamples) {
    const CounterexampleFiles files = files_of(counterexample);
    const auto put = [&](const std::string& name, const std::string& content) {
      write_file((std::filesystem::path(folder) / name).string(), content);
    };
    const SeenFailure& seen = counterexample.seen;
    put(files.p, written(seen.summands.p, Format::dat));
    put(files.q, written(seen.summands.q, Format::dat));
    if (!files.right.empty()) put(files.right, written(*seen.right, Format::wkt));
    if (!files.given.empty()) put(files.given, written(*seen.given, Format::wkt));
    put(files.picture, picture(counterexample, report.engine));
  }
}

std::string replay_line(const ConformanceReport& report, const ShrunkFailure& counterexample) {
  const CounterexampleFiles files = files_of(counterexample);
  return "oplus-check conformance --engine " + for_shell(report.engine) + " --pair " + files.p +
         " " + files.q;
}

}  // namespace oplus
