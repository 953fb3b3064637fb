// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "properties/runner/source_tree.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

/// The files of both folders.
std::set<std::filesystem::path> transcripts() {
  std::set<std::filesystem::path> files;
  for (const std::string folder : {"tests/checked/cli", "tests/properties"})
    for (const auto& entry :
         std::filesystem::directory_iterator(source_root() / folder / "transcripts"))
      files.insert(entry.path());
  return files;
}

/// What one of the streams of a command should be: all of it, or some of its parts.
struct Expected {
  std::string whole;
  std::vector<std::string> parts;
};

struct Step {
  std::size_t line;     ///< where it is in the transcript
  bool is_file;         ///< a file to write
  std::string subject;  ///< the file's name, or a script for Shell::run
  Expected out, err;    ///< out.whole is the content of a file
  std::optional<std::string> refusal;
  int exit_code = 0;
};

/// Reads lines of a mark, a blank and a text:
///   #        a comment
///   file     a file of that name; `>` gives its lines
///   $        a command; the lines below say what is expected of it:
///   >   !    a line of standard output, of standard error; where none is given, it is empty
///   >~  !~   a part of it; then nothing is expected of the rest
///   exit     its exit code, where that is not 0
///   refused  a refusal with this part of the message (Shell::expect_refusal)
std::vector<Step> steps_of(const std::filesystem::path& transcript) {
  std::vector<Step> steps;
  std::ifstream in(transcript);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string mark = line.substr(0, line.find(' '));
    const std::string text = mark == line ? "" : line.substr(mark.size() + 1);
    if (line.empty() || mark == "#") continue;
    if (mark == "$" || mark == "file") {
      steps.push_back({number, mark == "file", text, {}, {}, {}});
      continue;
    }
    Step& step = steps.at(steps.size() - 1);
    if (mark == ">")
      step.out.whole += text + '\n';
    else if (mark == "!")
      step.err.whole += text + '\n';
    else if (mark == ">~")
      step.out.parts.push_back(text);
    else if (mark == "!~")
      step.err.parts.push_back(text);
    else if (mark == "exit")
      step.exit_code = std::stoi(text);
    else if (mark == "refused")
      step.refusal = text;
    else
      ADD_FAILURE() << transcript << ':' << number << ": unknown mark " << mark;
  }
  return steps;
}

void expect_text(const Expected& expected, const std::string& text) {
  for (const std::string& part : expected.parts) EXPECT_TRUE(has(text, part));
  if (expected.parts.empty()) EXPECT_EQ(text, expected.whole);
}

class Transcript : public ShellWithRegions,
                   public testing::WithParamInterface<std::filesystem::path> {};

TEST_P(Transcript, is_what_the_program_prints) {
  const std::vector<Step> steps = steps_of(GetParam());
  EXPECT_GT(steps.size(), 3U);
  for (const Step& step : steps) {
    SCOPED_TRACE(GetParam().string() + ':' + std::to_string(step.line) + ": " + step.subject);
    if (step.is_file) {
      put(step.subject, step.out.whole);
    } else if (step.refusal) {
      expect_refusal(step.subject, *step.refusal);
    } else {
      const Ran ran = run(step.subject, step.exit_code);
      expect_text(step.out, ran.out);
      expect_text(step.err, ran.err);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Transcript, testing::ValuesIn(transcripts()),
                         [](const auto& instance) { return instance.param.stem().string(); });

}  // namespace
}  // namespace oplus
