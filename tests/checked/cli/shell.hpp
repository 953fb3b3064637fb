// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/program.hpp"
#include "properties/runner/child_process.hpp"
#include "properties/runner/temporary_folder.hpp"

namespace oplus {

struct Ran {
  int exit_code;
  std::string out;
  std::string err;

  long lines_of_err() const { return std::count(err.begin(), err.end(), '\n'); }
};

/// Whether a text has a part; a failure shows the text.
inline testing::AssertionResult has(const std::string& text, const std::string& part) {
  return (text.find(part) == std::string::npos ? testing::AssertionFailure()
                                               : testing::AssertionSuccess())
         << '"' << part << "\" in\n"
         << text;
}

/// Runs the program in an empty folder of its own.
class Shell : public testing::Test {
 protected:
  Shell() { std::filesystem::create_directory(place_ / "folder"); }

  /// Runs a bash script in which the program is called oplus. Nothing is on standard input. A pipe fails
  /// if one of its commands does. Where the script is one plain command of oplus that asks for none of
  /// that, the program's function is called instead, without bash and without a process: that takes a
  /// tenth of the time.
  Ran run(const std::string& script) const {
    std::istringstream blanks_apart(script);
    const std::vector<std::string> words{std::istream_iterator<std::string>(blanks_apart), {}};
    const bool is_plain = std::all_of(script.begin(), script.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || std::string_view(" -_./,=+").find(c) != std::string_view::npos;
    });
    return is_plain && !words.empty() && words[0] == "oplus" &&
                   std::find(words.begin(), words.end(), "-") == words.end()
               ? called(words)
               : run_by_bash(script);
  }

  /// The same, and expects that exit code.
  Ran run(const std::string& script, int exit_code) const {
    Ran ran = run(script);
    EXPECT_EQ(ran.exit_code, exit_code) << script << '\n' << ran.err;
    return ran;
  }

  std::filesystem::path folder() const { return place_ / "folder"; }

  void put(const std::string& file, const std::string& text) const {
    EXPECT_TRUE(static_cast<bool>(std::ofstream(folder() / file, std::ios::binary) << text))
        << file;
  }

  std::string content(const std::string& file) const {
    std::ifstream in(folder() / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder()))
      names.insert(entry.path().filename().string());
    return names;
  }

  /// Expects this on standard output, nothing on standard error, and the exit code.
  void expect_output(const std::string& script, const std::string& out, int exit_code = 0) const {
    const Ran ran = run(script, exit_code);
    EXPECT_EQ(ran.out, out) << script;
    EXPECT_EQ(ran.err, "") << script;
  }

  /// Expects one line on standard error that contains `part`, nothing on standard output, exit code
  /// 2, and no file left behind.
  void expect_refusal(const std::string& script, const std::string& part) const {
    const std::set<std::string> before = files();
    const Ran ran = run(script, 2);
    EXPECT_EQ(ran.out, "") << script;
    EXPECT_EQ(ran.lines_of_err(), 1) << script << "\n" << ran.err;
    EXPECT_TRUE(std::regex_search(ran.err, std::regex("^oplus(-check|-maintain)?: "))) << script;
    EXPECT_TRUE(has(ran.err, part)) << script;
    EXPECT_EQ(files(), before) << script;
  }

 private:
  Ran run_by_bash(const std::string& script) const {
    const std::filesystem::path program = program_beside("oplus");
    put("../script", "cd '" + folder().string() + "'\nPATH='" + program.parent_path().string() +
                         "':$PATH\nset -o pipefail\n" + script + "\n");
    const EndedProcess ended =
        run_program({"bash", (place_ / "script").string()}, {.is_quiet = true});
    const bool has_exited = ended.how == EndedProcess::How::exited;
    return {has_exited ? ended.code : -1, ended.output, ended.errors};
  }

  Ran called(const std::vector<std::string>& words) const {
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int exit_code = oplus::run(static_cast<int>(arguments.size()), arguments.data());
    // What a process would take with it.
    speech() = {};
    std::signal(SIGPIPE, SIG_DFL);
    std::filesystem::current_path(before);
    return {exit_code, testing::internal::GetCapturedStdout(),
            testing::internal::GetCapturedStderr()};
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path place_ = temporary_.path();
};

/// The same with regions in the folder.
class ShellWithRegions : public Shell {
 protected:
  ShellWithRegions() {
    put("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
    put("triangle.dat", "3\n0 0\n1 0\n0 1/3\n");
    put("frame.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))");
    put("full.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
    put("empty.wkt", "POLYGON EMPTY");
  }
};

}  // namespace oplus
