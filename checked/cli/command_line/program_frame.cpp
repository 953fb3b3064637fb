// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/program_frame.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <map>
#include <memory>
#include <system_error>

#include "checked/cli/command_line/help_formatter.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/cli/version.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

void set_up(CLI::App& program) {
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_help_flag("-h,--help", "show this help");
  program.set_version_flag("--version", program.get_name() + " " + version, "show the version");
  program.require_subcommand(1);
  program.fallthrough();
  // Both hold at once: a command line that is not understood is complained about in their manner.
  program
      .add_flag_callback(
          "--quiet", [] { speech().quiet = true; },
          "results and errors only: no progress, no notes")
      ->trigger_on_parse();
  static const std::map<std::string, ColourUse> uses = {
      {"auto", ColourUse::automatic}, {"always", ColourUse::always}, {"never", ColourUse::never}};
  program
      .add_option_function<std::string>(
          "--color", [](const std::string& when) { speech().colours = uses.at(when); },
          "colours: auto, on a terminal unless NO_COLOR is set; always; never")
      ->trigger_on_parse()
      ->check(CLI::IsMember(uses))
      ->type_name("WHEN");
}

std::string complaint(const CLI::App& program, const CLI::ParseError& error) {
  const auto used = program.get_subcommands();
  const std::string name = error.get_name();
  if (!used.empty() || (name != "RequiredError" && name != "ExtrasError"))
    return std::string(error.what()) + "; see " + program.get_name() + " " +
           (used.empty() ? "" : used.front()->get_name() + " ") + "--help";
  // CLI11 would ask for a command first.
  const std::vector<std::string> unknown = program.remaining();
  return (unknown.empty()
              ? "a command is needed"
              : "there is no " +
                    std::string(unknown.front().starts_with("-") ? "option " : "command ") +
                    unknown.front()) +
         "; see " + program.get_name() + " --help";
}

void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1)
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

void write_text(const std::string& path, const std::string& text) {
  try {
    write_file(path, text);
  } catch (const std::system_error& error) {
    throw UsageError("cannot write " + (path == "-" ? "standard output" : path) + ": " +
                     error.code().message());
  }
}

}  // namespace oplus
