// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cstdint>

#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/json_values.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/families/family.hpp"

namespace oplus {

namespace {

struct GenOptions {
  std::optional<std::string> family;
  std::optional<std::string> n;
  std::string seed = "1";
  std::string summand = "P";
  RegionOutput output;
  bool list = false;
  bool json = false;
};

/// By CLI11, -1 would be a huge number.
std::uint64_t whole_number(const std::string& option, const std::string& digits,
                           std::uint64_t largest) {
  std::uint64_t value = 0;
  const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failed != std::errc() || end != digits.data() + digits.size() || value > largest)
    throw UsageError(option + " is a whole number from 0 to " + std::to_string(largest) +
                     ", not '" + digits + "'");
  return value;
}

ExitCode list_as_json() {
  Json list = Json::array();
  for (const Family& family : families())
    list.push_back({{"name", family.name},
                    {"what", family.what},
                    {"smallest", family.smallest},
                    {"typical", family.typical},
                    {"largest", family.largest}});
  write_text("-", Json{{"families", list}}.dump(2) + "\n");
  return ExitCode::done;
}

ExitCode list() {
  std::size_t longest = 0;
  for (const Family& family : families()) longest = std::max(longest, family.name.size());
  std::string lines;
  for (const Family& family : families())
    lines += family.name + std::string(longest + 2 - family.name.size(), ' ') + family.what + "\n";
  write_text("-", lines);
  return ExitCode::done;
}

ExitCode gen(const GenOptions& options) {
  if (options.list) return options.json ? list_as_json() : list();
  if (!options.family) throw UsageError("gen needs a FAMILY; 'oplus gen --list' lists them");
  const Family* family = find_family(*options.family);
  if (family == nullptr)
    throw UsageError("there is no family '" + *options.family + "'; 'oplus gen --list' lists them");
  const std::uint64_t n =
      options.n ? whole_number("--n", *options.n, family->largest) : family->typical;
  const std::uint64_t seed = whole_number("--seed", options.seed, UINT64_MAX);
  if (n < family->smallest)
    throw UsageError("the family " + family->name + " takes --n of " +
                     std::to_string(family->smallest) + " or more");
  require_writable({options.output.path});
  const Format format = output_format(options.output);
  const Summands pair = generate(*family, n, seed);
  write_region(options.output, format, options.summand == "P" ? pair.p : pair.q);
  return ExitCode::done;
}

}  // namespace

void add_gen(Program& program) {
  const auto& [command, options] =
      program.add("gen", "Write a region of a family of test pairs", gen);
  // gen refuses unknown names itself.
  command.option("FAMILY NAME:{" + joined(families(), &Family::name, ",") + "}", options.family,
                 "the name of a family; 'oplus gen --list' lists them");
  const Option listing =
      command.flag("--list", options.list, "list the families, and what n is in each");
  command.flag("--json", options.json, "list them in JSON (docs/json.md)").needs(listing);
  command.option("--n N", options.n,
                 "the size; --list says what it counts in each family; by default a typical one");
  command.option("--seed S", options.seed,
                 "the same seed gives the same pair on every machine; by default 1");
  command.option("--summand NAME", options.summand, "which region of the pair; by default P")
      .one_of({"P", "Q"});
  add_output(command, options.output, "the region");
  command.footer(
      "Example:\n"
      "  oplus gen --list\n"
      "  oplus gen star --n 20 --seed 7 -o p.wkt\n"
      "  oplus gen star --n 20 --seed 7 --summand Q -o q.wkt");
}

}  // namespace oplus
