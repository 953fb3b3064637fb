// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/json_values.hpp"
#include "checked/cli/shared_options.hpp"
#include "reference/definitions/difference.hpp"

namespace oplus {

namespace {

struct CompareOptions {
  std::string a;
  std::string b;
  bool json = false;
};

std::string words(Location location) {
  switch (location) {
    case Location::outside:
      return "outside";
    case Location::boundary:
      return "on the boundary of";
    case Location::inside:
      return "inside";
  }
  return "";
}

std::string word(Location location) {
  return location == Location::boundary ? "boundary" : words(location);
}

std::string line(const std::string& name, const PlanarSet& sum) {
  std::string result = name + ":";
  for (const auto& [what, value] : statistics_of(sum))
    result += (result.back() == ':' ? " " : ", ") + std::string(what) + " " + in_text(value);
  return result + "\n";
}

std::string verdict(const std::optional<Difference>& found, const PlanarSet& a,
                    const PlanarSet& b) {
  if (!found) return painted(Paint::good, "equal", std::cout) + "\n";
  return painted(Paint::bad, "not equal", std::cout) + ": " + found->what +
         "\nwitness: " + to_string(found->witness) + " is " + words(found->in_a) +
         " the first and " + words(found->in_b) + " the second\n" + line("first", a) +
         line("second", b);
}

std::string json_verdict(const std::optional<Difference>& found, const PlanarSet& a,
                         const PlanarSet& b) {
  Json object = {{"equal", !found}};
  if (found) {
    object["what"] = found->what;
    object["witness"] = {
        {"at", json(found->witness)}, {"first", word(found->in_a)}, {"second", word(found->in_b)}};
  }
  object["first"] = json(statistics_of(a));
  object["second"] = json(statistics_of(b));
  return object.dump(2) + "\n";
}

ExitCode compare(const CompareOptions& options) {
  require_one_standard_input({options.a, options.b});
  const PlanarSet a = read_canonical_sum(options.a);
  const PlanarSet b = read_canonical_sum(options.b);
  const std::optional<Difference> found = difference(a, b);
  write_text("-", (options.json ? json_verdict : verdict)(found, a, b));
  return found ? ExitCode::not_equal : ExitCode::done;
}

}  // namespace

void add_compare(Program& program) {
  const auto& [command, options] = program.add(
      "compare",
      "Check whether two sums are equal; if not, give a point that is in one of them only",
      compare);
  command.file("A", options.a, "a sum or a region (docs/files.md); - is standard input").required();
  command.file("B", options.b, "the other, in any of these formats").required();
  command.flag("--json", options.json, "answer in JSON (docs/json.md)");
  command.footer(
      "Example:\n"
      "  oplus gen star --n 8 --summand P -o p.wkt\n"
      "  oplus gen star --n 8 --summand Q -o q.wkt\n"
      "  oplus sum p.wkt q.wkt -o fast.wkt\n"
      "  oplus sum p.wkt q.wkt -o slow.wkt --engine oracle\n"
      "  oplus compare fast.wkt slow.wkt\n"
      "\n"
      "Exit codes:\n"
      "  0  equal\n"
      "  1  not equal");
}

}  // namespace oplus
