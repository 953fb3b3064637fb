// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/commands.hpp"
#include "properties/compare/compare.hpp"
#include "properties/compare/conformance_sources.hpp"
#include "properties/compare/sources.hpp"

namespace oplus {

namespace {

struct Settings : CompareOptions {
  ConformanceChoice choice;
  std::vector<std::string> parts;
};

int conformance(Settings settings) {
  settings.choice.seed = settings.campaign.seed;
  std::vector<TaskSource> sources = conformance_sources(given_pairs(settings));
  for (const std::string& file : settings.parts) sources.push_back(parts_source(file));
  if (sources.empty()) sources = conformance_sources(settings.choice);
  return compare("conformance", settings, sources);
}

}  // namespace

void add_conformance_command(Program& program) {
  const auto& [command, settings] = program.add(
      "conformance",
      "Check the sums of one implementation against the oracle or sums of convex parts, statements and laws",
      conformance);
  Campaign& campaign = settings.campaign;
  ConformanceChoice& choice = settings.choice;
  campaign.shrink_tries = 1000;
  add_engine_option(
      command, settings,
      "The implementation: an engine of oplus, a peer, or exec:CMD; see 'diff --help'")
      .required();
  add_pair_option(command, settings);
  command.option(
      "--parts FILE", settings.parts,
      "Only no-fit polygons, the sums of P and -Q, of the parts in this file, one a line; may "
      "be repeated");
  command.option("--part NAME", choice.parts, "Only this part; may be repeated")
      .one_of(conformance_parts());
  command.option("--seed", campaign.seed, "Same seed, same pairs").default_shown();
  command.option("--budget", choice.budget, "Pairs in all, the corpus not counted")
      .range(std::size_t{1}, std::size_t{1000000000})
      .default_shown();
  command.option("--cases", choice.cases, "Pairs per grid, family, statement and law, instead")
      .range(std::size_t{1}, std::size_t{1000000000});
  command
      .option("--shrink", campaign.shrink_tries,
              "The most pairs to try when a counterexample is shrunk; for hangs a twentieth")
      .default_shown();
  add_limit_options(command, settings);
  add_run_options(command, settings);
  command.footer(
      "Parts, in the order of the run: grids (all pairs of small polygons on small grids, or an even\n"
      "selection), corpus, families (random pairs against the judge), statements (of the thesis),\n"
      "laws (of the sum).\n"
      "\n"
      "Example:\n"
      "  oplus-check conformance --engine slide --report conformance.md\n"
      "  oplus-check conformance --engine 'exec:my-sum {p} {q}' --report conformance.xml\n"
      "  oplus-check conformance --engine clipper --judge convex-parts --parts parts.wkt\n"
      "\n"
      "Exit codes:\n"
      "  0  it conforms\n"
      "  1  it does not\n"
      "  2  invalid input or usage, a file that cannot be read or written, or nothing compared\n"
      "  5  interrupted by SIGINT or SIGTERM; the reports contain what was compared until then, and with\n"
      "     --resume the same command goes on. A second signal ends the program at once");
}

}  // namespace oplus
