// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/program_frame.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "checked/cli/command_line/completion.hpp"
#include "checked/cli/command_line/early_ends.hpp"
#include "checked/cli/command_line/help_formatter.hpp"
#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/exit_code.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/version.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Requires: the program has no command yet, since commands inherit.
void set_up(CLI::App& program) {
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_help_flag("-h,--help", "show this help");
  program.set_version_flag("-V,--version", program.get_name() + " " + version, "show the version");
  program.require_subcommand(1);
  program.fallthrough();
  // Both take effect while parsing, so that they hold for error messages about the command line.
  const Command all(program);
  all.flag(
         "--quiet", [] { speech().quiet = true; }, "results and errors only: no progress, no notes")
      .at_once();
  all.choice<ColourUse>("--color WHEN", speech().colours,
                        {{"auto", ColourUse::automatic},
                         {"always", ColourUse::always},
                         {"never", ColourUse::never}},
                        "colours: auto, on a terminal unless NO_COLOR is set; always; never")
      .at_once();
}

/// The complaint about a word in the place of the command that is neither one nor an option; else empty.
std::string unknown_word(const CLI::App& program, const std::string& first_word) {
  const std::vector<std::string> unknown = program.remaining();
  if (unknown.empty()) return "";
  // What a command does not expect is among them.
  if (!program.get_subcommands().empty() && unknown.front() != first_word) return "";
  return "there is no " + std::string(unknown.front().starts_with("-") ? "option " : "command ") +
         unknown.front();
}

/// What is wrong with a command line, and which help to read.
std::string complaint(const CLI::App& program, const std::string& first_word,
                      const CLI::ParseError& error) {
  const auto used = program.get_subcommands();
  const std::string see = "; see " + program.get_name() + " ";
  // CLI11 would ask for a command, or for its arguments, first.
  if (const std::string unknown = unknown_word(program, first_word); !unknown.empty())
    return unknown + see + "--help";
  if (used.empty() && error.get_name() == "RequiredError")
    return "a command is needed" + see + "--help";
  std::string names;
  for (const CLI::App* each = &program; !each->get_subcommands().empty();) {
    each = each->get_subcommands().front();
    names += each->get_name() + " ";
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error))  // CLI11 would reverse them
    return "not expected: " + boost::algorithm::join(program.remaining(true), " ") + see + names +
           "--help";
  return error.what() + see + names + "--help";
}

/// Opens standard streams that were closed before the start, the wrong way round, so that their use
/// fails: the first file opened would otherwise take their place.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1)
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

/// Adds the exit codes to the help of a command that does not list its own; 2 and 3 also where it lists
/// only 0 and 1.
void add_exit_codes(CLI::App& command) {
  std::string footer = command.get_footer();
  if (footer.find("Exit codes:") == std::string::npos)
    footer += (footer.empty() ? "" : "\n\n") + std::string("Exit codes:\n  0  done");
  else if (footer.find("\n  2  ") != std::string::npos)
    return;
  command.footer(footer +
                 "\n"
                 "  2  invalid input or usage, or a file that cannot be read or written\n"
                 "  3  a bug in oplus; please report it");
}

/// Says where the pages are that the help of a command names.
void say_where_pages_are(CLI::App& command) {
  if (command.help().find("docs/") == std::string::npos) return;
  const std::string footer = command.get_footer();
  command.footer("docs/ is in the sources, and in share/doc/oplus where oplus is installed." +
                 (footer.empty() ? "" : "\n\n" + footer));
}

/// The words of the command line; `help COMMAND` is `COMMAND --help`.
std::vector<std::string> words_of(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && words.front() == "help") {
    std::erase(words, "help");
    words.push_back("--help");
  }
  return words;
}

/// The command that is asked for; none where help or completion may need all.
std::optional<std::string> only_command(const std::vector<std::string>& words) {
  if (words == std::vector<std::string>{"--version"}) return "";
  if (words.empty() || words.front().starts_with("-")) return std::nullopt;
  return words.front();
}

int parse_and_do(const ProgramFrame& frame, AddCommands add_commands, int argc,
                 const char* const* argv) {
  CLI::App app(frame.what, frame.name);
  set_up(app);
  app.footer("'" + frame.name + " help COMMAND' shows a command's help, as does '" + frame.name +
             " COMMAND --help'.\n\n" + frame.footer);
  std::vector<std::string> words = words_of(argc, argv);
  Program program{app, only_command(words)};
  add_commands(program);
  if (program.needs("completion")) add_completion_command(program);
  for (CLI::App* command : app.get_subcommands({})) {
    add_exit_codes(*command);
    for (CLI::App* below : command->get_subcommands({})) add_exit_codes(*below);
  }
  if (argc > 2 && argv[1] == std::string("--complete")) {
    write_text("-", completions(app, {argv + 2, argv + argc}));
    return 0;
  }
  const std::string first_word = words.empty() ? "" : words.front();
  try {
    std::ranges::reverse(words);  // as CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::Success& asked) {
    // Help and version are no answer to a command that does not exist.
    if (const std::string unknown = unknown_word(app, first_word); !unknown.empty())
      throw UsageError(unknown + "; see " + app.get_name() + " --help");
    // Only now, since all helps would take a third of the time of a small command.
    for (CLI::App* command : app.get_subcommands()) say_where_pages_are(*command);
    std::ostringstream text;
    app.exit(asked, text, text);
    write_text("-", text.str());
    return 0;
  } catch (const CLI::ParseError& error) {
    throw UsageError(complaint(app, first_word, error));
  }
  const int exit_code = [&] {
    std::optional<ShownStep> step;
    if (frame.shows_commands)
      step.emplace(frame.name + " " + app.get_subcommands().front()->get_name());
    return program.work();
  }();
  // Output that was not written is an error.
  if (!std::cout.flush()) throw UsageError("cannot write standard output");
  return exit_code;
}

int fail(ExitCode code, const std::string& why) {
  say_error(why);
  return static_cast<int>(code);
}

int fail_with_bug(const std::string& what) {
  return fail(ExitCode::bug, "a bug in oplus: " + what + "; please report it with the input");
}

}  // namespace

int run_program(const ProgramFrame& frame, AddCommands add_commands, int argc,
                const char* const* argv) noexcept {
  occupy_closed_streams();
  // A reader that closes the pipe ends the program quietly, as it does others, even where it was ignored.
  std::signal(SIGPIPE, SIG_DFL);
  prepare_for_early_ends();
  return exit_code_of([&] {
    speech().program = frame.name;
    return parse_and_do(frame, add_commands, argc, argv);
  });
}

int exit_code_of(const std::function<int()>& work) noexcept {
  try {
    return work();
  } catch (const InvalidInput& error) {
    return fail(ExitCode::invalid, error.what());
  } catch (const UsageError& error) {
    return fail(ExitCode::invalid, error.what());
  } catch (const std::system_error& error) {
    return fail(ExitCode::invalid, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::invalid, "there is not enough memory for this input");
  } catch (const std::exception& error) {
    return fail_with_bug(error.what());
  } catch (...) {
    return fail_with_bug("an unknown exception");
  }
}

}  // namespace oplus
