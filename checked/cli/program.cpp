// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <sstream>
#include <string>

#include "checked/cli/crash.hpp"
#include "checked/cli/outcome.hpp"
#include "checked/cli/output.hpp"
#include "checked/cli/subcommands.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/cli/version.hpp"

namespace oplus {

namespace {

/// A standard stream that was closed before the start would otherwise be the first file opened, and
/// what is meant for the stream would end up in it. Opened the wrong way round, so its use fails.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1)
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

ExitCode parse_and_do(int argc, const char* const* argv) {
  CLI::App program("oplus computes Minkowski sums of polygons, exactly.", "oplus");
  program.set_version_flag("--version", std::string("oplus ") + version);
  program.require_subcommand(1);
  program.get_formatter()->column_width(28);
  program.footer(
      "Example:\n"
      "  oplus gen tight --n 6 --summand P -o p.wkt\n"
      "  oplus gen tight --n 6 --summand Q -o q.wkt\n"
      "  oplus sum p.wkt q.wkt --open -o sum.wkt --svg sum.svg\n"
      "\n"
      "Exit codes:\n"
      "  0  done; of compare: equal\n"
      "  1  of compare: not equal\n"
      "  2  invalid input or usage, or a file that cannot be read or written\n"
      "  3  a bug in oplus; please report it");
  Action chosen;
  add_sum(program, chosen);
  add_compare(program, chosen);
  add_verify(program, chosen);
  add_draw(program, chosen);
  add_gen(program, chosen);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    std::ostringstream text;
    program.exit(asked, text, text);
    write_output("-", text.str());
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    const auto used = program.get_subcommands();
    throw UsageError(std::string(error.what()) + "; see oplus " +
                     (used.empty() ? "" : used.front()->get_name() + " ") + "--help");
  }
  return chosen();
}

}  // namespace

int run(int argc, const char* const* argv) noexcept {
  report_crashes();
  occupy_closed_streams();
  // A reader that closes its pipe is an output that cannot be written, not a death.
  signal(SIGPIPE, SIG_IGN);
  return exit_code_of([&] { return parse_and_do(argc, argv); });
}

}  // namespace oplus
