// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "properties/runner/source_tree.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

/// All files in folders of that name.
std::set<std::filesystem::path> transcripts() {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_root() / "tests"))
    if (entry.path().parent_path().filename() == "transcripts") files.insert(entry.path());
  return files;
}

using Lines = std::vector<std::string>;

struct Step {
  std::size_t number;   ///< of its line in the transcript
  std::string subject;  ///< the file's name, or a script for Shell::run
  bool is_file;
  std::map<std::string, Lines> lines;  ///< by their mark
};

/// A transcript has lines of a mark, a blank and a text:
///   #        a comment
///   file     a file of that name; `>` gives its lines
///   $        a command; the lines below say what is expected of it:
///   >   !    all lines of standard output, of standard error; where none is given, it is empty
///   >~  !~   or parts of it
///   exit     its exit code, where that is not 0
///   refused  or, alone, a refusal with this part of the message (Shell::expect_refusal)
std::vector<Step> steps_of(std::istream&& transcript) {
  std::vector<Step> steps;
  std::size_t number = 0;
  for (std::string line; std::getline(transcript, line);) {
    ++number;
    const std::string mark = line.substr(0, line.find(' '));
    const std::string text = mark == line ? "" : line.substr(mark.size() + 1);
    if (line.empty() || mark == "#") continue;
    if (mark == "$" || mark == "file")
      steps.push_back({number, text, mark == "file", {}});
    else
      steps.at(steps.size() - 1).lines[mark].push_back(text);
  }
  return steps;
}

/// Whether it has unknown marks, one beside which another would not be looked at, or an empty part.
bool is_unclear(const Step& step) {
  std::string marks;
  for (const auto& [mark, lines] : step.lines) {
    marks += mark + ' ';
    const bool is_whole = mark == ">" || mark == "!";
    if (!is_whole && std::find(lines.begin(), lines.end(), "") != lines.end()) return true;
    if ((mark == "exit" || mark == "refused") && lines.size() > 1) return true;
  }
  const std::regex clear(step.is_file ? "(> )?" : "(!~? )?(>~? )?(exit )?|refused ");
  return !std::regex_match(marks, clear);
}

std::string text_of(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

class Transcript : public ShellWithRegions,
                   public testing::WithParamInterface<std::filesystem::path> {
 protected:
  void take(Step step) const {
    ASSERT_FALSE(is_unclear(step)) << "it is unclear what is expected";
    if (step.is_file) {
      put(step.subject, text_of(step.lines[">"]));
    } else if (step.lines.contains("refused")) {
      expect_refusal(step.subject, step.lines["refused"][0]);
    } else {
      const int exit_code = step.lines.contains("exit") ? std::stoi(step.lines["exit"][0]) : 0;
      const Ran ran = run(step.subject, exit_code);
      for (const auto& [mark, text] : {std::pair(">", ran.out), {"!", ran.err}}) {
        const Lines& parts = step.lines[mark + std::string("~")];
        for (const std::string& part : parts) EXPECT_TRUE(has(text, part));
        if (parts.empty()) {
          EXPECT_EQ(text, text_of(step.lines[mark])) << "of the mark " << mark;
        }
      }
    }
  }
};

TEST_P(Transcript, is_what_the_programs_do) {
  const std::vector<Step> steps = steps_of(std::ifstream(GetParam()));
  EXPECT_GT(steps.size(), 3U);
  for (const Step& step : steps) {
    SCOPED_TRACE(GetParam().string() + ':' + std::to_string(step.number) + ": " + step.subject);
    take(step);
  }
}

TEST(Transcripts, are_refused_where_they_are_unclear) {
  for (const std::string marks :
       {">! a", ">~", ">~ ", "!~", "> a\n>~ a", "! a\n!~ a", "exit 1\nexit 2", "exit", "refused",
        "refused a\nrefused b", "exit 2\nrefused a", "! a\nrefused a"})
    EXPECT_TRUE(is_unclear(steps_of(std::istringstream("$ true\n" + marks)).at(0))) << marks;
  for (const std::string mark : {"!", "exit 0", ">~ a", "refused a"})
    EXPECT_TRUE(is_unclear(steps_of(std::istringstream("file a\n" + mark)).at(0))) << mark;
  EXPECT_THROW(steps_of(std::istringstream("> a\n$ true")), std::out_of_range);
}

INSTANTIATE_TEST_SUITE_P(Each, Transcript, testing::ValuesIn(transcripts()),
                         [](const auto& instance) { return instance.param.stem().string(); });

}  // namespace
}  // namespace oplus
