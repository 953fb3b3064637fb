// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_command.hpp"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "checked/cli/usage_error.hpp"
#include "properties/fuzz/all_targets.hpp"
#include "properties/fuzz/fuzz_program.hpp"
#include "properties/fuzz/shown_input.hpp"
#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

namespace fs = std::filesystem;

struct Settings {
  std::vector<std::string> targets;
  bool lists = false;
  std::size_t seconds = 60;
  std::size_t runs = 0;
  std::uint32_t seed = 1;
  std::string corpus;
  std::string binaries;
  std::string out = "oplus-findings/fuzz";
  std::string show;
  std::vector<std::string> encode;
  bool json = false;
};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const FuzzTarget& target : fuzz_targets()) all.push_back(target.name);
  return all;
}

/// Where the preset `fuzz` puts its programs: in the build folder beside the one of this program.
fs::path folder_of_binaries(const Settings& settings) {
  if (!settings.binaries.empty()) return settings.binaries;
  std::error_code unknown;
  const fs::path self = fs::read_symlink("/proc/self/exe", unknown);
  return self.parent_path().parent_path().parent_path() / "fuzz" / "bin";
}

int list(const Settings& settings) {
  nlohmann::json json = nlohmann::json::array();
  for (const FuzzTarget& target : fuzz_targets()) {
    json.push_back({{"target", target.name}, {"what", target.what}});
    if (!settings.json) {
      std::string name = target.name;
      name.resize(8, ' ');
      std::cout << name << ' ' << target.what << '\n';
    }
  }
  if (settings.json) std::cout << nlohmann::json{{"targets", json}}.dump(2) << '\n';
  return 0;
}

int show(const Settings& settings) {
  if (settings.targets.size() != 1)
    throw UsageError("--show wants one target, whose input the file is");
  const ShownInput found =
      shown(*find_fuzz_target(settings.targets[0]),
            text_of_file(settings.show, "an input of the target"), settings.out);
  std::cout << found.text;
  return found.is_a_finding ? 1 : 0;
}

int encode(const Settings& settings) {
  const Summands summands{read_region_file(settings.encode.at(0)).region,
                          read_region_file(settings.encode.at(1)).region};
  const auto input = input_of_pair(summands);
  if (!input)
    throw UsageError(
        "such a pair is no input of slide; expected integer coordinates from -128 to 127, at most 16 "
        "vertices a chain and 24 a summand");
  write_file(settings.encode.at(2), *input);
  return 0;
}

int fuzz(Settings settings) {
  if (settings.lists) return list(settings);
  if (!settings.show.empty()) return show(settings);
  if (!settings.encode.empty()) return encode(settings);
  if (settings.targets.empty()) settings.targets = names();
  const fs::path binaries = folder_of_binaries(settings);
  const fs::path inputs = source_root() / "properties" / "fuzz";
  for (const std::string& target : settings.targets)
    if (!fs::exists(binaries / ("oplus-fuzz-" + target)))
      throw UsageError("there is no " + (binaries / ("oplus-fuzz-" + target)).string() +
                       "; to build it: cmake --preset fuzz && cmake --build --preset fuzz");
  nlohmann::json json = nlohmann::json::array();
  bool found = false;
  for (const std::string& name : settings.targets) {
    if (!settings.json) std::cerr << "fuzzing " << name << std::endl;
    FuzzRun wanted;
    wanted.program = binaries / ("oplus-fuzz-" + name);
    wanted.target = name;
    wanted.longest = find_fuzz_target(name)->longest;
    wanted.seconds = settings.runs > 0 ? 0 : settings.seconds;
    wanted.runs = settings.runs;
    wanted.seed = settings.seed;
    wanted.corpus =
        (settings.corpus.empty() ? fs::path(settings.out) / "corpus" : fs::path(settings.corpus)) /
        name;
    wanted.seeds = inputs / "seeds" / name;
    wanted.dictionary = inputs / "dictionaries" / (name + ".dict");
    wanted.out = settings.out;
    const FuzzReport report = run(wanted);
    found = found || !report.finding.empty();
    json.push_back(to_json(report));
    if (!settings.json) std::cout << line_of(report) << std::endl;
  }
  if (settings.json) std::cout << nlohmann::json{{"targets", json}}.dump(2) << '\n';
  return found ? 1 : 0;
}

}  // namespace

void add_fuzz_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("fuzz", "Fuzz the readers, and slide against winding numbers");
  const auto settings = std::make_shared<Settings>();
  command->add_option("target", settings->targets, "What to fuzz; default: every target")
      ->type_name("TARGET")
      ->check(CLI::IsMember(names()));
  command->add_flag("--list", settings->lists, "List the targets");
  command->add_option("--seconds", settings->seconds, "How long, each target")
      ->check(CLI::Range(1, 100000000))
      ->capture_default_str();
  command->add_option("--runs", settings->runs, "How many inputs, each target, instead of how long")
      ->check(CLI::Range(1, 1000000000));
  command->add_option("--seed", settings->seed, "Of the random numbers")
      ->check(CLI::Range(1U, 4294967295U))
      ->capture_default_str();
  command
      ->add_option("--corpus", settings->corpus,
                   "Inputs that showed something new: a folder for each target; default: corpus in "
                   "--out")
      ->type_name("DIR");
  command
      ->add_option("--binaries", settings->binaries,
                   "Where the fuzz programs are; default: fuzz/bin, beside this build's folder")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  command->add_option("--out", settings->out, "Folder for logs, and inputs that show a finding")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--json", settings->json,
                    "Print the result, or the list, as JSON (docs/json.md)");
  command
      ->add_option("--show", settings->show,
                   "Run the target on this input, here and now; of slide, shrink the pair that "
                   "shows a finding, and write it to --out as .dat files")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  command->add_option("--encode", settings->encode, "Write the input of slide for a pair of files")
      ->type_name("P Q FILE")
      ->type_size(3)
      ->expected(1);
  command->footer(
      "Example:\n"
      "  oplus-maintain fuzz slide --seconds 600 --corpus slide-corpus\n"
      "\n"
      "Exit codes:\n"
      "  0  no finding\n"
      "  1  a finding\n"
      "  2  bad input or usage, or the fuzz build is missing; says how to build it");
  command->callback([settings, &exit_code] { exit_code = fuzz(*settings); });
}

}  // namespace oplus
