// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "checked/cli/usage_error.hpp"
#include "properties/commands.hpp"
#include "properties/fuzz/fuzz_report.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/pair_of_bytes.hpp"
#include "properties/fuzz/slide_check.hpp"
#include "properties/runner/child_process.hpp"
#include "properties/runner/finding.hpp"
#include "properties/runner/shrinking.hpp"
#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The result of an input in this build.
struct ShownInput {
  std::string text;  ///< lines for people
  bool is_a_finding = false;
};

/// What is wrong with slide on a pair, or empty.
std::string fault_of(const Summands& summands) {
  try {
    check_slide(summands);
  } catch (const std::exception& e) {
    return e.what();
  }
  return {};
}

ShownInput shown_pair(Summands summands, const std::filesystem::path& folder) {
  ShownInput result;
  if (!fault_of(summands).empty()) {
    result.is_a_finding = true;
    summands = shrink(std::move(summands),
                      [](const Summands& smaller) { return !fault_of(smaller).empty(); });
  }
  const Finding files = write_finding(folder, "fuzz-slide", summands);
  std::ostringstream out;
  out << "P: " << wkt(summands.p) << "\nQ: " << wkt(summands.q) << "\nwritten to "
      << files.p.string() << " and " << files.q.string() << '\n'
      << (result.is_a_finding ? "finding: " + fault_of(summands) : "no finding") << '\n';
  result.text = out.str();
  return result;
}

/// Runs the target on an input. Of slide, the pair is written as two .dat files into a folder; it
/// is shrunk before, if it shows a finding. Throws std::system_error.
ShownInput shown(const FuzzTarget& target, std::string_view input,
                 const std::filesystem::path& folder) {
  if (&target == &slide_target) {
    auto pair = pair_of_bytes(input);
    if (!pair) return {"rejected: a summand that is not valid\n", false};
    return shown_pair(std::move(*pair), folder);
  }
  try {
    const bool reached = target.run(input) == FuzzOutcome::reached;
    return {reached ? "read; no finding\n" : "refused; no finding\n", false};
  } catch (const std::exception& e) {
    return {"finding: " + std::string(e.what()) + '\n', true};
  }
}

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

/// In the order in which they are listed.
const FuzzTarget* const all_targets[] = {&dat_target,  &wkt_target,     &geojson_target,
                                         &sums_target, &layouts_target, &slide_target};

const FuzzTarget& target_named(const std::string& name) {
  return **std::ranges::find(all_targets, name, &FuzzTarget::name);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const FuzzTarget* target : all_targets) all.push_back(target->name);
  return all;
}

/// Where the preset `fuzz` puts its programs: in the build folder beside the one of this program.
fs::path folder_of_binaries(const Settings& settings) {
  if (!settings.binaries.empty()) return settings.binaries;
  return fs::path(program_beside("")).parent_path().parent_path().parent_path() / "fuzz" / "bin";
}

int list(const Settings& settings) {
  nlohmann::json json = nlohmann::json::array();
  for (const FuzzTarget* target : all_targets) {
    json.push_back({{"target", target->name}, {"what", target->what}});
    if (!settings.json)
      std::cout << std::left << std::setw(8) << target->name << ' ' << target->what << '\n';
  }
  if (settings.json) std::cout << nlohmann::json{{"targets", json}}.dump(2) << '\n';
  return 0;
}

int show(const Settings& settings) {
  if (settings.targets.size() != 1)
    throw UsageError("--show needs exactly one target, that of the input");
  const ShownInput found =
      shown(target_named(settings.targets[0]),
            text_of_file(settings.show, "an input of the target"), settings.out);
  std::cout << found.text;
  return found.is_a_finding ? 1 : 0;
}

int encode(const Settings& settings) {
  const Summands summands{read_region_file(settings.encode.at(0)).region,
                          read_region_file(settings.encode.at(1)).region};
  const auto input = bytes_of_pair(summands);
  if (!input)
    throw UsageError(
        "such a pair cannot be an input of slide; expected integer coordinates from -128 to 127, and at "
        "most 127 vertices per chain");
  write_file(settings.encode.at(2), *input);
  return 0;
}

/// Runs the target's program, keeps what it writes in OUT/TARGET.log, and waits for it.
FuzzReport run_program_of(const FuzzTarget& target, const fs::path& program,
                          const Settings& settings) {
  const fs::path out = settings.out, inputs = source_root() / "properties" / "fuzz";
  const fs::path corpus =
      (settings.corpus.empty() ? out / "corpus" : fs::path(settings.corpus)) / target.name;
  const fs::path log = out / (target.name + std::string(".log"));
  fs::create_directories(corpus);
  fs::create_directories(out);
  const std::string limit = settings.runs > 0
                                ? "-runs=" + std::to_string(settings.runs)
                                : "-max_total_time=" + std::to_string(settings.seconds);
  const EndedProcess ended = run_program(
      {"/bin/sh", "-c", R"(exec "$@" >"$0" 2>&1)", log, program,
       "-seed=" + std::to_string(settings.seed), "-max_len=" + std::to_string(target.longest),
       // Weighing inputs by their coverage takes as long as running them.
       "-entropic=0", "-print_final_stats=1", "-timeout=120", "-rss_limit_mb=4096",
       "-artifact_prefix=" + (out / target.name).string() + "-", limit,
       "-dict=" + (inputs / "dictionaries" / target.name).string() + ".dict", corpus,
       inputs / "seeds" / target.name},
      {});
  return report_of(target.name, text_of_file(log, "what the program wrote"),
                   ended.how == EndedProcess::How::exited && ended.code == 0);
}

int fuzz(Settings settings) {
  if (settings.lists) return list(settings);
  if (!settings.show.empty()) return show(settings);
  if (!settings.encode.empty()) return encode(settings);
  if (settings.targets.empty()) settings.targets = names();
  const auto program = [binaries = folder_of_binaries(settings)](const std::string& target) {
    return binaries / ("oplus-fuzz-" + target);
  };
  for (const std::string& target : settings.targets)
    if (!fs::exists(program(target)))
      throw UsageError("there is no " + program(target).string() +
                       "; to build it: cmake --preset fuzz && cmake --build --preset fuzz");
  nlohmann::json json = nlohmann::json::array();
  bool found = false;
  for (const std::string& target : settings.targets) {
    if (!settings.json) std::cerr << "fuzzing " << target << std::endl;
    const FuzzReport report = run_program_of(target_named(target), program(target), settings);
    found = found || !report.finding.empty();
    json.push_back(to_json(report));
    if (!settings.json) std::cout << line_of(report) << std::endl;
  }
  if (settings.json) std::cout << nlohmann::json{{"targets", json}}.dump(2) << '\n';
  return found ? 1 : 0;
}

}  // namespace

void add_fuzz_command(Program& program) {
  const auto& [command, settings] =
      program.add("fuzz", "Fuzz the readers, and slide against sums of convex parts", fuzz);
  command.option("target TARGET", settings.targets, "What to fuzz; default: every target")
      .one_of(names());
  command.flag("--list", settings.lists, "List the targets");
  command.option("--seconds", settings.seconds, "Seconds per target")
      .range(1, 100000000)
      .default_shown();
  command.option("--runs", settings.runs, "Inputs per target, instead of --seconds")
      .range(1, 1000000000);
  command.option("--seed", settings.seed, "The seed of the random numbers")
      .range(std::size_t{1}, std::size_t{4294967295})
      .default_shown();
  command.option(
      "--corpus DIR", settings.corpus,
      "Folder for inputs that reached new code, one below it per target; default: corpus "
      "in --out");
  command
      .option("--binaries DIR", settings.binaries,
              "Where the fuzz programs are; default: fuzz/bin, beside this build's folder")
      .existing_folder();
  command.option("--out DIR", settings.out, "Folder for logs, and inputs that show a finding")
      .default_shown();
  command.flag("--json", settings.json, "Print the result, or the list, as JSON (docs/json.md)");
  command
      .option("--show FILE", settings.show,
              "Run the target on this input in this build; of slide, shrink the pair of a "
              "finding, and write it to --out as .dat files")
      .existing_file();
  command
      .option("--encode P Q FILE", settings.encode, "Write the input of slide for a pair of files")
      .values_each_time(3)
      .values(1);
  command.footer(
      "Example:\n"
      "  oplus-maintain fuzz slide --seconds 600 --corpus slide-corpus\n"
      "\n"
      "Exit codes:\n"
      "  0  no finding\n"
      "  1  a finding\n"
      "  2  invalid input or usage, or the fuzz build is missing: the message says how to build it");
}

}  // namespace oplus
