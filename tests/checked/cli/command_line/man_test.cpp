// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/command_line/help_pages.hpp"

namespace oplus {
namespace {

class Man : public HelpPages {
 protected:
  /// As roff has it.
  static std::string with_minus(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '-' ? std::string("\\-") : std::string(1, c);
    return result;
  }
};

TEST_F(Man, has_a_page_for_each_command_with_all_its_options) {
  for (const std::string& program : programs) {
    ASSERT_EQ(run(program + " man --all pages").exit_code, 0);
    const std::string of_program = content("pages/" + program + ".1");
    const std::vector<std::string> names = commands(program);
    for (const std::string& command : names) {
      SCOPED_TRACE(program + " " + command);
      EXPECT_NE(of_program.find(".TP\n\\fB" + with_minus(command) + "\\fR\n"), std::string::npos);
      const std::string page = content("pages/" + program + "-" + command + ".1");
      EXPECT_EQ(page, run(program + " man " + command).out);
      const std::vector<std::string> of_command = options(program + " " + command);
      ASSERT_GE(of_command.size(), 2U);
      for (const std::string& option : of_command)
        EXPECT_NE(page.find("\\fB" + with_minus(option) + "\\fR"), std::string::npos) << option;
      for (const std::string part : {".SH NAME\n", ".SH SYNOPSIS\n", ".SH EXAMPLES\n.EX\n"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(of_program, run(program + " man").out);
    EXPECT_NE(of_program.find(".SH EXIT STATUS\n.TP\n\\fB0\\fR\n"), std::string::npos);
  }
}

TEST_F(Man, is_read_without_a_warning) {
  for (const std::string& program : programs) {
    ASSERT_EQ(run(program + " man --all pages").exit_code, 0);
    for (const std::string formatter : {"groff -man -Tutf8 -ww -z", "mandoc -Tlint -Wwarning"}) {
      const Ran ran = run("! command -v " + formatter.substr(0, formatter.find(' ')) +
                          " >/dev/null || " + formatter + " pages/*.1");
      EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
      EXPECT_EQ(ran.out + ran.err, "");
    }
  }
}

TEST_F(Man, refuses_what_is_no_command) {
  expect_refusal("oplus man nonsense", "nonsense");
  expect_refusal("oplus man sum --all pages", "--all");
  expect_refusal("oplus man --all /dev/null/pages", "/dev/null/pages");
  expect_refusal("oplus man >/dev/full", "standard output");
}

}  // namespace
}  // namespace oplus
