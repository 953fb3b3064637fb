// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>

#include "checked/cli/command_line/man_page.hpp"
#include "checked/cli/command_line/program_frame.hpp"
#include "checked/cli/usage_error.hpp"

namespace oplus {

namespace {

struct ManOptions {
  std::string command;
  std::string folder;
  std::string output = "-";
};

std::string page(const DescribedProgram& program, const std::string& name) {
  if (name.empty()) return man_page(program);
  const auto found =
      std::find_if(program.commands.begin(), program.commands.end(),
                   [&](const DescribedCommand& command) { return command.name == name; });
  if (found == program.commands.end())
    throw UsageError("there is no command '" + name + "'; see " + program.name + " --help");
  return man_page(program, *found);
}

/// With commas: those that are there when it is asked, others are added later.
std::string command_names(const CLI::App& program) {
  std::string names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names += (names.empty() ? "" : ",") + command->get_name();
  return names;
}

/// Writes oplus.1, oplus-sum.1, ... .
void write_all(const DescribedProgram& program, const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw UsageError("cannot make " + folder.string() + ": " + failed.message());
  write_text((folder / (program.name + ".1")).string(), man_page(program));
  for (const DescribedCommand& command : program.commands)
    write_text((folder / (program.name + "-" + command.name + ".1")).string(),
               man_page(program, command));
}

}  // namespace

void add_man_command(CLI::App& program, const Choose& choose) {
  const auto options = std::make_shared<ManOptions>();
  CLI::App& command =
      *program.add_subcommand("man", "Print the manual page of this program or of a command");
  CLI::Option* of = command.add_option("COMMAND", options->command,
                                       "a command; without it the page of the program");
  of->type_name_fn([&program] { return "NAME:{" + command_names(program) + "}"; });
  CLI::Option* output =
      command.add_option("-o,--output", options->output, "write it there, not to standard output")
          ->type_name("FILE");
  command.add_option("--all", options->folder, "write all pages into this folder")
      ->excludes(of)
      ->excludes(output)
      ->type_name("DIR");
  const std::string& name = program.get_name();
  command.footer("Example:\n  " + name + " man\n  " + name + " man completion -o page.1\n  " +
                 name +
                 " man --all man1\n"
                 "\n"
                 "To read one: man -l page.1. An installed oplus has brought its pages along.");
  command.callback([options, &program, choose] {
    choose([options, &program] {
      const DescribedProgram all = described(program);
      if (options->folder.empty())
        write_text(options->output, page(all, options->command));
      else
        write_all(all, options->folder);
    });
  });
}

}  // namespace oplus
