// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/program.hpp"

#include <signal.h>

#include <sstream>
#include <string>

#include "checked/cli/command_line/program_frame.hpp"
#include "checked/cli/crash.hpp"
#include "checked/cli/outcome.hpp"
#include "checked/cli/output.hpp"
#include "checked/cli/subcommands.hpp"
#include "checked/cli/usage_error.hpp"

namespace oplus {

namespace {

ExitCode parse_and_do(int argc, const char* const* argv) {
  CLI::App program("Compute Minkowski sums of polygons, exactly", "oplus");
  set_up(program);
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
  add_reflect(program, chosen);
  add_gen(program, chosen);
  const Choose choose = [&chosen](const std::function<void()>& work) {
    chosen = [work] {
      work();
      return ExitCode::done;
    };
  };
  add_completion_command(program, choose);
  add_man_command(program, choose);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    std::ostringstream text;
    program.exit(asked, text, text);
    write_output("-", text.str());
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    throw UsageError(complaint(program, error));
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
