// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/commands.hpp"

#include <iostream>

#include "properties/pages/page_files.hpp"
#include "properties/runner/registry.hpp"
#include "properties/runner/source_tree.hpp"

namespace oplus {

namespace {

struct Settings {
  std::string docs = (source_root() / "docs").string();
  bool check = false;
};

int print_and_judge(const std::vector<std::string>& lines, const std::string& all_well) {
  for (const std::string& line : lines) std::cout << line << '\n';
  if (lines.empty())
    std::cout << all_well << '\n';
  else
    std::cout << "bash docs/renew writes the records, pages and drawings again\n";
  return lines.empty() ? 0 : 1;
}

int run(const Settings& settings) {
  const Registry registry =
      registry_with_records({settings.docs, source_root() / "properties/proofs",
                             source_root() / "properties/proofs/smt"});
  const std::vector<std::string> defects = defects_of_records(registry);
  if (!defects.empty()) return print_and_judge(defects, {});
  const std::vector<Page> pages = all_pages(registry);
  const std::string number = std::to_string(pages.size()) + " files";
  if (settings.check)
    return print_and_judge(stale_files(pages, settings.docs), number + " up to date");
  write_pages(pages, settings.docs);
  std::cout << number << " written\n";
  return 0;
}

}  // namespace

void add_pages_command(Program& program) {
  const auto& [command, settings] = program.add(
      "pages", "Write docs/theorems/, docs/theorems.md and docs/mutants.md from the registry", run);
  command.flag("--check", settings.check, "Write nothing; fail where a page is out of date");
  command
      .option("--docs", settings.docs,
              "The folder docs/, with the records theorems/*.json; default: docs/ of the "
              "sources from which this program was built")
      .type("DIR");
  command.footer(
      "Records come from properties --record and, in the preset check, mutants --record.\n"
      "\n"
      "Example:\n"
      "  oplus-maintain pages --check\n"
      "\n"
      "Exit codes:\n"
      "  0  written or up to date\n"
      "  1  out of date\n"
      "  2  a record cannot be read");
}

}  // namespace oplus
