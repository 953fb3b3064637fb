// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "checked/cli/input.hpp"
#include "checked/cli/output.hpp"
#include "checked/cli/statistics.hpp"
#include "checked/cli/subcommands.hpp"
#include "reference/definitions/difference.hpp"

namespace oplus {

namespace {

struct CompareOptions {
  std::string a;
  std::string b;
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

std::string line(const std::string& name, const MinkowskiSum& sum) {
  std::string result = name + ":";
  for (const auto& [what, value] : statistics_of(sum))
    result += (result.back() == ':' ? " " : ", ") + what + " " + value;
  return result + "\n";
}

ExitCode compare(const CompareOptions& options) {
  require_one_standard_input({options.a, options.b});
  const MinkowskiSum a = read_given_sum(options.a);
  const MinkowskiSum b = read_given_sum(options.b);
  const std::optional<Difference> found = difference(a, b);
  if (!found) {
    write_output("-", "equal\n");
    return ExitCode::done;
  }
  write_output("-", "not equal: " + found->what + "\nwitness: " + to_string(found->witness) +
                        " is " + words(found->in_a) + " the first and " + words(found->in_b) +
                        " the second\n" + line("first", a) + line("second", b));
  return ExitCode::not_equal;
}

}  // namespace

void add_compare(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command = *program.add_subcommand(
      "compare", "Say whether two sums are equal, with a point that tells them apart if not");
  command.add_option("A", options->a, "a sum or a region; - is standard input")
      ->required()
      ->type_name("FILE");
  command.add_option("B", options->b, "the other")->required()->type_name("FILE");
  command.footer(
      "Example:\n"
      "  oplus gen star --n 8 --summand P -o p.wkt\n"
      "  oplus gen star --n 8 --summand Q -o q.wkt\n"
      "  oplus sum p.wkt q.wkt -o fast.wkt\n"
      "  oplus sum p.wkt q.wkt -o slow.wkt --engine oracle\n"
      "  oplus compare fast.wkt slow.wkt\n"
      "Exit code 0 if equal, 1 if not.");
  command.callback([options, &chosen] { chosen = [options] { return compare(*options); }; });
}

}  // namespace oplus
