// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/cli/command_line/completion.hpp"

namespace oplus {

namespace {

/// What is offered where a value is due: a branch of a case over "command:option" or
/// "command:number of the argument".
std::string branch(const std::string& pattern, const DescribedOption& option) {
  std::string offer = ":";
  if (!option.choices.empty()) {
    offer = "words='";
    for (const std::string& choice : option.choices)
      offer += (&choice == &option.choices.front() ? "" : " ") + choice;
    offer += "'";
  } else if (option.takes_files()) {
    offer = "files=-f";
  } else if (option.takes_folders()) {
    offer = "files=-d";
  }
  return "    " + pattern + ") " + offer + " ;;\n";
}

std::string pattern_of(const std::string& command, const DescribedOption& option) {
  std::string pattern;
  for (const std::string& name : option.names)
    pattern += (pattern.empty() ? "" : "|") + command + ":" + name;
  return pattern;
}

/// How many words each option takes that takes some.
std::string counts(const std::string& command, const std::vector<DescribedOption>& options) {
  std::string text;
  for (const DescribedOption& option : options)
    if (option.values > 0)
      text += "          " + pattern_of(command, option) +
              ") due=" + std::to_string(option.values) + " ;;\n";
  return text;
}

std::string offers(const std::string& command, const std::vector<DescribedOption>& options) {
  std::string text;
  for (const DescribedOption& option : options)
    if (option.values > 0) text += branch(pattern_of(command, option), option);
  return text;
}

/// The last argument that may be repeated stands for all behind it.
std::string argument_offers(const DescribedCommand& command) {
  std::string text;
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const DescribedOption& argument = command.arguments[i];
    text += branch(command.name + ":" + (argument.repeats ? "*" : std::to_string(i)), argument);
  }
  return text;
}

std::string option_names(const std::vector<DescribedOption>& options) {
  std::string names;
  for (const DescribedOption& option : options)
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  return names;
}

}  // namespace

std::string bash_completion(const DescribedProgram& program) {
  const std::string name = function_name(program.name);
  std::string commands, value_counts, value_offers, arguments, names;
  for (const DescribedCommand& command : program.commands) {
    commands += (commands.empty() ? "" : " ") + command.name;
    value_counts += counts(command.name, command.options);
    value_offers += offers(command.name, command.options);
    arguments += argument_offers(command);
    names += "      " + command.name + ") words='" + option_names(command.options) + " " +
             option_names(program.options) + "' ;;\n";
  }
  return "# bash completion of " + program.name + "; written by " + program.name +
         " completion bash\n" +  //
         name + R"(() {
  local IFS=$' \t\n' word current command= option= due=0 arguments=0 words= files= i
  # The word under the cursor; bash makes --option=value three words.
  current=${COMP_WORDS[COMP_CWORD]}
  [[ $current == = ]] && current=
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    [[ $word == = ]] && continue
    if ((due > 0)); then
      ((--due))
      continue
    fi
    case $word in
      -?*)
        option=$word
        case $command:$word in
)" + value_counts +
         counts("*", program.options) + R"(        esac
        ;;
      *)
        if [[ -z $command ]]; then command=$word; else ((++arguments)); fi
        ;;
    esac
  done
  if ((due > 0)); then
    case $command:$option in
)" + value_offers +
         offers("*", program.options) + R"(    esac
  elif [[ -z $command && $current != -* ]]; then
    words=')" +
         commands + R"('
  elif [[ $current == -* ]]; then
    case $command in
)" + names +
         "      *) words='" + option_names(program.options) + "' ;;\n" + R"(    esac
  else
    case $command:$arguments in
)" + arguments +
         R"(    esac
  fi
  COMPREPLY=()
  if [[ -n $files ]]; then
    mapfile -t COMPREPLY < <(compgen $files -- "$current")
    compopt -o filenames 2>/dev/null
  elif [[ -n $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  fi
}
complete -F )" +
         name + " " + program.name + "\n";
}

std::string function_name(const std::string& program) {
  std::string name = "_" + program;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace oplus
