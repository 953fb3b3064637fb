// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/completion.hpp"

namespace oplus {

namespace {

/// Brackets, colons and backslashes mean something in a specification of _arguments.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string action(const DescribedOption& option) {
  if (option.takes_files()) return "_files";
  if (option.takes_folders()) return "_files -/";
  if (option.choices.empty()) return " ";
  std::string words = "(";
  for (const std::string& choice : option.choices)
    words += (words.size() == 1 ? "" : " ") + escaped(choice);
  return words + ")";
}

std::string values(const DescribedOption& option) {
  std::string text;
  for (std::size_t i = 0; i < option.values; ++i)
    text += ":" + escaped(option.value.empty() ? "value" : option.value) + ":" + action(option);
  return text;
}

/// A line for each name; where an option is not to be repeated, one name excludes the others.
std::string specifications(const std::vector<DescribedOption>& options) {
  std::string text;
  for (const DescribedOption& option : options) {
    std::string others;
    for (const std::string& name : option.names) others += (others.empty() ? "" : " ") + name;
    for (const std::string& name : option.names) {
      const std::string before = option.repeats ? "*" : "(" + others + ")";
      const std::string assigned = option.values == 1 && name.starts_with("--") ? "=" : "";
      text += "        " +
              in_quotes(before + name + assigned + "[" + escaped(short_description(option)) + "]" +
                        values(option)) +
              " \\\n";
    }
  }
  return text;
}

std::string argument_specifications(const std::vector<DescribedOption>& arguments) {
  std::string text;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const DescribedOption& argument = arguments[i];
    text += "        " +
            in_quotes((argument.repeats ? "*" : std::to_string(i + 1)) + ":" +
                      escaped(argument.names.front()) + ":" + action(argument)) +
            " \\\n";
  }
  return text;
}

std::string without_last_backslash(std::string text) {
  return text.erase(text.rfind(" \\\n")) + "\n";
}

}  // namespace

std::string zsh_completion(const DescribedProgram& program) {
  const std::string name = function_name(program.name);
  std::string commands, cases;
  for (const DescribedCommand& command : program.commands) {
    commands += "        " + in_quotes(escaped(command.name) + ":" + command.what) + "\n";
    cases +=
        "        " + command.name + ")\n          _arguments -s \\\n" +
        without_last_backslash(specifications(command.options) + specifications(program.options) +
                               argument_specifications(command.arguments)) +
        "          ;;\n";
  }
  return "#compdef " + program.name + "\n# zsh completion; written by " + program.name +
         " completion zsh\n" +  //
         name + "() {\n  local context state state_descr line\n  typeset -A opt_args\n" +
         "  _arguments -C \\\n" + specifications(program.options) +
         "        '1:command:->command' \\\n        '*::argument:->argument'\n" +
         "  case $state in\n    command)\n      local -a commands\n      commands=(\n" + commands +
         "      )\n      _describe command commands\n      ;;\n    argument)\n" +
         "      case $line[1] in\n" + cases + "      esac\n      ;;\n  esac\n}\n" +
         "if [ \"$funcstack[1]\" = " + name + " ]; then\n  " + name + " \"$@\"\nelse\n  compdef " +
         name + " " + program.name + "\nfi\n";
}

}  // namespace oplus
