// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/completion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string/split.hpp>
#include <utility>

namespace oplus {

namespace {

using Lines = std::vector<std::string>;

/// The word and the first part of its description, such as "how to compute".
std::string line(const std::string& word, const std::string& what) {
  std::size_t end = what.size();
  for (const char* const mark : {": ", "; ", ". "}) end = std::min(end, what.find(mark));
  return word + '\t' + what.substr(0, end);
}

/// CLI11 keeps the names that an option takes in its type: "NAME:{a,b}".
Lines values(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  if (const std::size_t names = type.find(":{"); names != std::string::npos) {
    Lines lines;
    return boost::algorithm::split(lines, type.substr(names + 2, type.rfind('}') - names - 2),
                                   [](char c) { return c == ','; });
  }
  if (type == "DIR") return {":folders"};
  const bool files =
      type.find("FILE") != std::string::npos || type.starts_with("P Q") || type == "REPORT";
  return files ? Lines{":files"} : Lines{};
}

bool is_argument(const CLI::Option* option) { return option->get_positional(); }

bool is_offered(const CLI::Option* option) {
  return !is_argument(option) && !option->get_description().empty();
}

/// The words that are read so far.
struct ReadSoFar {
  const CLI::App* program;
  const CLI::App* command = program;
  const CLI::Option* option = nullptr;  ///< the last one
  int due = 0;                          ///< how many words are its values
  std::size_t arguments = 0;

  const CLI::Option* option_called(const std::string& name) const {
    const CLI::Option* const own = command->get_option_no_throw(name);
    return own != nullptr ? own : program->get_option_no_throw(name);
  }

  /// Returns whether it is possible here.
  bool read(const std::string& word) {
    if (word == "=") return true;  // bash makes --option=value three words
    if (word == "help" && command == program && due == 0) return true;
    if (due > 0) {
      --due;
    } else if (word.size() > 1 && word[0] == '-') {
      option = option_called(word);
      due = option == nullptr || option->get_items_expected_max() == 0
                ? 0
                : std::max(option->get_items_expected_min(), 1);
    } else {
      const auto called =
          command->get_subcommands([&](const CLI::App* each) { return each->get_name() == word; });
      if (called.empty() && command == program) return false;
      if (called.empty() || arguments > 0)
        ++arguments;
      else
        command = called.front();
    }
    return true;
  }

  Lines options() const {
    Lines lines;
    for (const CLI::App* app : {command, program})
      for (const CLI::Option* each : app->get_options(is_offered))
        for (const auto& [dash, names] :
             {std::pair("-", each->get_snames()), std::pair("--", each->get_lnames())})
          for (const std::string& name : names)
            lines.push_back(line(dash + name, each->get_description()));
    return lines;
  }

  Lines commands() const {
    Lines lines;
    if (arguments > 0) return lines;
    for (const CLI::App* each : command->get_subcommands({}))
      lines.push_back(line(each->get_name(), each->get_description()));
    return lines;
  }

  /// The last argument that may be repeated stands for all behind it.
  Lines of_argument() const {
    const auto all = command->get_options(is_argument);
    if (arguments < all.size()) return values(*all[arguments]);
    const bool repeats = !all.empty() && all.back()->get_expected_max() > 1;
    return repeats ? values(*all.back()) : Lines{};
  }
};

}  // namespace

std::string completions(const CLI::App& program, const std::vector<std::string>& words) {
  ReadSoFar so_far{&program};
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (!so_far.read(words[i])) return "";
  const std::string word = words.back() == "=" ? "" : words.back();
  std::string before;  // --option=
  Lines lines;
  if (so_far.due > 0) {
    lines = values(*so_far.option);
  } else if (const std::size_t equals = word.find('=');
             word.starts_with("--") && equals != std::string::npos) {
    const CLI::Option* const option = so_far.option_called(word.substr(0, equals));
    if (option != nullptr) lines = values(*option);
    before = word.substr(0, equals + 1);
  } else if (word.starts_with('-')) {
    lines = so_far.options();
  } else {
    // Scripts expect :files before words.
    lines = so_far.of_argument();
    for (const std::string& each : so_far.commands()) lines.push_back(each);
  }
  std::string text;
  for (const std::string& each : lines) {
    if (each.starts_with(':'))
      text += each + "\n";
    else if ((before + each).starts_with(word))
      text += before + each + "\n";
  }
  return text;
}

}  // namespace oplus
