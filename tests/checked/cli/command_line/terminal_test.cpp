// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/terminal.hpp"

#include <iostream>
#include <sstream>

#include "checked/cli/command_line/progress.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Terminal : public ShellWithRegions {
 protected:
  /// The output of the command on a new terminal.
  std::string on_terminal(const std::string& command) const {
    return run("env -u NO_COLOR TERM=xterm script -qefc '" + command + "' seen").out;
  }
};

TEST_F(Terminal, a_file_that_takes_long_to_read_shows_how_far_it_is) {
  // The writer into the pipe waits until it is shown, but not for ever.
  put("slow",
      "(for i in {1..600}; do grep -q reading seen && break; sleep 0.1; done; cat square.wkt) |\n"
      "oplus reflect -");
  const std::string shown = on_terminal("bash slow");
  EXPECT_TRUE(has(shown, "\rreading standard input ... "));
  EXPECT_TRUE(has(shown, "\r\033[KPOLYGON ((0 0, -1 0"));
  put("slow", "(sleep 1.5; cat square.wkt) | oplus reflect - $*");
  EXPECT_EQ(on_terminal("bash slow --quiet").substr(0, 7), "POLYGON");
  EXPECT_EQ(run("bash slow").err, "");
}

TEST_F(Terminal, no_command_is_silent) {
  // All that read a file: what comes from it late stands for all that takes long.
  const std::vector<std::string> commands = {"sum - full.wkt",
                                             "nfp - full.wkt",
                                             "ifp full.wkt -",
                                             "erode full.wkt -",
                                             "open full.wkt -",
                                             "close - full.wkt",
                                             "complement - --format dat",
                                             "reflect -",
                                             "transform - --scale 2",
                                             "verify square.wkt - full.wkt",
                                             "certify square.wkt - full.wkt",
                                             "compare - full.wkt",
                                             "repair -",
                                             "draw square.wkt - -o d.svg",
                                             "batch -",
                                             "batch --parts -"};
  std::string all;
  for (std::size_t c = 0; c < commands.size(); ++c) {
    const std::string n = std::to_string(c);
    put("slow" + n, "(for i in {1..600}; do grep -q ' [1-9] s' seen" + n +
                        " && break; sleep 0.1; done; cat square.wkt) |\noplus " + commands[c] +
                        " >/dev/null\n");
    all += "script -qefc 'bash slow" + n + "' seen" + n + " >/dev/null &\n";
  }
  run("export TERM=xterm\n" + all + "wait");
  for (std::size_t c = 0; c < commands.size(); ++c)
    EXPECT_TRUE(has(content("seen" + std::to_string(c)), " ... 1 s\033[K")) << commands[c];
}

TEST_F(Terminal, a_sum_that_takes_long_to_write_says_so) {
  // The reader of the pipe waits until it is shown, but not for ever.
  put("slow",
      "mkfifo pipe\n"
      "(for i in {1..600}; do grep -q writing seen && break; sleep 0.1; done; cat pipe >got) &\n"
      "oplus sum square.wkt square.wkt -o pipe --format wkt; wait; cat got");
  const std::string shown = on_terminal("bash slow");
  EXPECT_TRUE(has(shown, "\rwriting the sum ... "));
  EXPECT_TRUE(has(shown, "\r\033[KPOLYGON ((0 0, 2 0"));
}

TEST_F(Terminal, a_bar_is_as_long_as_what_is_done) {
  EXPECT_EQ(bar("reading", 1, 4, std::chrono::seconds(2)),
            "reading [" + std::string(10, '#') + std::string(30, ' ') + "] 25 %, 6 s left");
  EXPECT_EQ(bar("x", 7, 7, std::chrono::seconds(2)),
            "x [" + std::string(40, '#') + "] 100 %, 0 s left");
}

TEST_F(Terminal, other_streams_are_not_coloured) {
  std::ostringstream elsewhere;
  EXPECT_EQ(painted(Paint::bad, "text", elsewhere), "text");
}

TEST_F(Terminal, the_last_line_is_the_verdict) {
  const std::string red = "\033[31m", green = "\033[32m", plain = "\033[0m";
  speech().colours = ColourUse::always;
  EXPECT_EQ(with_painted_verdict("a\nb\nc\n", Paint::good, std::cout),
            "a\nb\n" + green + "c" + plain + "\n");
  EXPECT_EQ(with_painted_verdict("c", Paint::bad, std::cout), red + "c" + plain);
  EXPECT_EQ(with_painted_verdict("", Paint::bad, std::cout), "");
  speech().colours = ColourUse::automatic;
}

/// Of both programs: one line and exit code 2.
TEST_F(Terminal, usage_errors_are_a_line) {
  for (const std::string program : {"oplus", "oplus-check"}) {
    for (const std::string rest :
         {"", "nonsense", "--nonsense", "--color", "--color sometimes", "completion --nonsense",
          "completion bash --quiet=maybe", "completion bash too much"}) {
      const Ran ran = run(program + " " + rest, 2);
      EXPECT_EQ(ran.out, "") << program << ' ' << rest;
      EXPECT_EQ(ran.lines_of_err(), 1) << program << ' ' << rest << '\n' << ran.err;
      EXPECT_EQ(ran.err.substr(0, program.size() + 2), program + ": ");
      EXPECT_TRUE(has(ran.err, "--help\n"));
    }
  }
  EXPECT_TRUE(has(run("oplus nonsense").err, "there is no command nonsense"));
}

TEST_F(Terminal, output_that_cannot_be_written_is_an_error) {
  for (const std::string command :
       {"oplus --help", "oplus gen --list", "oplus completion bash",
        "oplus compare square.wkt square.wkt", "oplus-check --help", "oplus-check theorems",
        "oplus-check theorems --json", "oplus-check completion fish",
        "oplus-check diff --pair square.wkt square.wkt"}) {
    for (const std::string output : {">/dev/full", ">&-"}) {
      const Ran ran = run(command + " " + output, 2);
      EXPECT_TRUE(has(ran.err, "cannot write standard output")) << command << output;
    }
  }
}

}  // namespace
}  // namespace oplus
