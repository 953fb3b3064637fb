// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "properties/runner/temporary_folder.hpp"

namespace oplus {

struct Ran {
  int exit_code;
  std::string out;
  std::string err;

  long lines_of_err() const { return std::count(err.begin(), err.end(), '\n'); }
};

/// Runs the built program in an empty folder of its own.
class Shell : public testing::Test {
 protected:
  Shell() { std::filesystem::create_directory(place_ / "folder"); }

  /// Runs a bash script in which the program is called oplus. Nothing is on standard input.
  Ran run(const std::string& script) const {
    const std::filesystem::path program = OPLUS_PROGRAM;
    put("../script", "cd '" + (place_ / "folder").string() + "'\nPATH='" +
                         program.parent_path().string() + "':$PATH\n" + script + "\n");
    const std::string at = "'" + place_.string() + "/";
    const int status =
        std::system(("bash " + at + "script' >" + at + "out' 2>" + at + "err' </dev/null").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content("../out"), content("../err")};
  }

  void put(const std::string& file, const std::string& text) const {
    std::ofstream(place_ / "folder" / file, std::ios::binary) << text;
  }

  std::string content(const std::string& file) const {
    std::ifstream in(place_ / "folder" / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(place_ / "folder"))
      names.insert(entry.path().filename().string());
    return names;
  }

  /// Expects one line on standard error that contains `part`, nothing on standard output, exit code
  /// 2, and no file left behind.
  void expect_refusal(const std::string& script, const std::string& part) const {
    const std::set<std::string> before = files();
    const Ran ran = run(script);
    EXPECT_EQ(ran.exit_code, 2) << script << "\n" << ran.err;
    EXPECT_EQ(ran.out, "") << script;
    EXPECT_EQ(ran.lines_of_err(), 1) << script << "\n" << ran.err;
    EXPECT_EQ(ran.err.substr(0, 7), "oplus: ") << script;
    EXPECT_NE(ran.err.find(part), std::string::npos) << script << "\n" << ran.err;
    EXPECT_EQ(files(), before) << script;
  }

 private:
  const TemporaryFolder temporary_;
  const std::filesystem::path place_ = temporary_.path();
};

}  // namespace oplus
