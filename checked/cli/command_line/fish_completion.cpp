// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/completion.hpp"

namespace oplus {

namespace {

/// Within single quotes of fish a backslash escapes a quote and itself.
std::string in_fish_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string words(const std::vector<std::string>& choices) {
  std::string text;
  for (const std::string& choice : choices) text += (text.empty() ? "" : " ") + choice;
  return in_fish_quotes(text);
}

/// What is offered for the value: -x takes no files, -r asks for a value.
std::string offered(const DescribedOption& option) {
  if (!option.choices.empty()) return " -x -a " + words(option.choices);
  if (option.takes_files()) return " -r -F";
  if (option.takes_folders()) return " -x -a '(__fish_complete_directories)'";
  return " -x";
}

std::string lines(const std::string& start, const std::vector<DescribedOption>& options) {
  std::string text;
  for (const DescribedOption& option : options) {
    text += start;
    for (const std::string& name : option.names)
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (option.values > 0) text += offered(option);
    text += " -d " + in_fish_quotes(short_description(option)) + "\n";
  }
  return text;
}

std::string argument_lines(const std::string& start,
                           const std::vector<DescribedOption>& arguments) {
  std::string text;
  for (const DescribedOption& argument : arguments) {
    if (!argument.choices.empty())
      text += start + " -a " + words(argument.choices) + "\n";
    else if (argument.takes_files())
      text += start + " -F\n";
  }
  return text;
}

}  // namespace

std::string fish_completion(const DescribedProgram& program) {
  const std::string complete = "complete -c " + program.name;
  std::string text = "# fish completion of " + program.name + "; written by " + program.name +
                     " completion fish\n" + complete + " -f\n" + lines(complete, program.options);
  for (const DescribedCommand& command : program.commands) {
    text += complete + " -n __fish_use_subcommand -a " + command.name + " -d " +
            in_fish_quotes(command.what) + "\n";
    const std::string start = complete + " -n '__fish_seen_subcommand_from " + command.name + "'";
    text += lines(start, command.options) + argument_lines(start, command.arguments);
  }
  return text;
}

}  // namespace oplus
