// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/algorithm/string/join.hpp>
#include <filesystem>
#include <map>

#include "checked/arrangement/hole_test.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "properties/commands.hpp"
#include "properties/compare/certified_engine.hpp"
#include "properties/compare/compare.hpp"
#include "properties/compare/engine_called.hpp"
#include "properties/compare/operation.hpp"
#include "properties/compare/sources.hpp"
#include "properties/runner/source_tree.hpp"

namespace oplus {

namespace {

struct Settings : CompareOptions {
  std::vector<std::string> folders;
  std::vector<std::string> families;
  std::optional<std::size_t> cases;
};

/// How many cases of a family the main job runs.
std::size_t main_job_cases(const std::string& family) {
  static const std::map<std::string, std::size_t> counts = {{"grid", 1500},  {"holes", 150},
                                                            {"tight", 150},  {"components", 75},
                                                            {"islands", 75}, {"fork", 6}};
  const auto count = counts.find(family);
  return count == counts.end() ? 40 : count->second;
}

std::vector<std::string> hole_test_names() {
  std::vector<std::string> names = {"all"};
  for (const auto& [name, method] : hole_test_methods()) names.push_back(name);
  return names;
}

std::vector<std::string> operations_and_sums() {
  std::vector<std::string> names = compared_operations();
  names.insert(names.begin(), "sum");
  return names;
}

std::string other_engines() {
  std::vector<Engine> others = peers();
  others.insert(others.begin(), {certified_engine({}), proved_engine({})});
  std::string lines;
  for (const Engine& peer : others)
    lines += "  " + peer.name + std::string(22 - peer.name.size(), ' ') + peer.what + '\n';
  return lines;
}

/// The pairs that were asked for; by default those of the main job: the published pairs, which an
/// installed program may be without, and all families; of an operation, some families whose pairs just fit.
std::vector<TaskSource> chosen_sources(Settings& settings) {
  const Campaign& campaign = settings.campaign;
  if (settings.pairs.empty() && settings.folders.empty() && settings.families.empty()) {
    settings.families = texts(families(), &Family::name);
    if (!campaign.is_of_sums())
      settings.families = {"grid", "tight", "holes", "components", "islands"};
    else if (std::filesystem::is_directory(data_folder()))
      settings.folders = {data_folder()};
    else
      text_output(settings.json || speech().quiet)
          << "the published pairs are left out: there is no folder " << data_folder().string()
          << '\n';
  }
  std::vector<Task> given = given_pairs(settings);
  for (const std::string& folder : settings.folders) {
    for (Task& pair : pairs_of_folder(folder)) {
      settings.campaign.pairs.push_back(pair.name);
      given.push_back(std::move(pair));
    }
  }
  std::vector<TaskSource> sources;
  if (!given.empty()) sources.push_back(given_source(std::move(given)));
  for (const std::string& name : settings.families) {
    // An operation's definition costs more than the oracle's sums.
    const std::size_t cases = main_job_cases(name) / (campaign.is_of_sums() ? 1 : 6);
    TaskSource pairs = family_source(*find_family(name), settings.cases.value_or(cases),
                                     campaign.seed, campaign.n);
    sources.push_back(campaign.is_of_sums() ? pairs : pairs_that_fit(pairs, campaign.operation));
  }
  if (sources.empty()) throw UsageError("diff found no pair to compare");
  return sources;
}

int diff(Settings settings) {
  if (settings.reports.empty())
    settings.reports = {(std::filesystem::path(settings.out) / "diff.json").string()};
  const Campaign& chosen = settings.campaign;
  if (!chosen.is_of_sums() && chosen.judge != judges().front().name)
    throw UsageError("--judge " + chosen.judge +
                     " is for sums; an operation is compared with "
                     "its definition, which is the oracle's");
  if (!chosen.is_of_sums() && !settings.folders.empty())
    throw UsageError("--folder is for sums; --operation takes --pair or --family");
  const std::vector<TaskSource> sources = chosen_sources(settings);
  return compare("diff", settings, sources);
}

}  // namespace

void add_diff_command(Program& program) {
  const auto& [command, settings] = program.add(
      "diff",
      "Compare engines with the oracle, or with sums of convex parts, on pairs that you name, or on those "
      "that properties/run compares",
      diff);
  Campaign& campaign = settings.campaign;
  command
      .option(
          "--operation NAME", campaign.operation,
          "What to compute of each pair with each engine's sums, and to compare with the operation's "
          "definition: " +
              boost::join(compared_operations(), ", ") + "; sum: the sums themselves")
      .one_of(operations_and_sums())
      .default_shown();
  add_engine_option(
      command, settings,
      "The engine to check; may be repeated; default: all of oplus, certified, and, for small pairs, proved; other "
      "libraries and programs: below");
  command
      .option(
          "--collision-test NAME", campaign.hole_test,
          "The collision test of the engines; all: each is asked about each point, and they must "
          "agree")
      .one_of(hole_test_names())
      .default_shown();
  command.option("--hole-test", campaign.hole_test, "").one_of(hole_test_names());
  add_pair_option(command, settings);
  command
      .option("--folder DIR", settings.folders,
              "The files of a folder: NAME_part1 with NAME_part2, the rest with each other")
      .existing_folder();
  command.option("--family NAME", settings.families, "A generated family; may be repeated")
      .one_of(texts(families(), &Family::name));
  command
      .option("--cases", settings.cases,
              "Pairs of each family; default: as many as properties/run has")
      .range(std::size_t{1}, std::size_t{1000000000});
  command.option("--n", campaign.n,
                 "The largest size of a generated pair, as the family understands it");
  command.option("--seed", campaign.seed, "Same seed, same pairs").default_shown();
  add_shrink_option(command, campaign);
  command.option("--shrink-tries", campaign.shrink_tries, "Pairs tried to shrink one")
      .default_shown();
  add_limit_options(command, settings);
  add_run_options(command, settings);
  command.footer(
      "Without --report the report is written to diff.json in --out.\n"
      "\n"
      "Other libraries and programs, each sum in a process of its own:\n" +
      other_engines() +
      "  exec:CMD              any program: the shell runs CMD with {p} and {q} replaced by files\n"
      "                        in WKT, or these appended; it writes the sum. Open sums are asked for\n"
      "                        only if CMD contains {boundary}, which is replaced by closed or open.\n"
      "                        Exit code 77 says that such a pair is unsupported.\n"
      "\n"
      "Example:\n"
      "  oplus-check diff --family grid --cases 500 --seed 7\n"
      "  oplus-check diff --pair p.wkt q.wkt --engine slide\n"
      "  oplus-check diff --operation ifp --family tight --cases 200\n"
      "  oplus-check diff --engine 'exec:my-sum {p} {q}' --time-limit 5 --family holes\n"
      "\n"
      "Exit codes:\n"
      "  0  all agree\n"
      "  1  a disagreement\n"
      "  2  invalid input or usage, a file that cannot be read or written, or nothing compared\n"
      "  5  interrupted by SIGINT or SIGTERM; the reports contain what was compared until then, and with\n"
      "     --resume the same command goes on. A second signal ends the program at once");
}

}  // namespace oplus
