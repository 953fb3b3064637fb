// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/help_formatter.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <sstream>
#include <utility>

namespace oplus {

namespace {

constexpr std::size_t left_column = 28;
constexpr std::size_t right_column = 72;

/// The same words in lines of the right column.
std::string in_lines(const std::string& text) {
  std::string lines;
  std::size_t column = 0;
  std::istringstream words(text);
  for (std::string word; words >> word; column += word.size()) {
    const bool fits = column + 1 + word.size() <= right_column;
    if (!lines.empty()) lines += fits ? ' ' : '\n';
    column = fits ? column + 1 : 0;
    lines += word;
  }
  return lines;
}

}  // namespace

HelpFormatter::HelpFormatter() {
  column_width(left_column);
  label("Positionals", "Arguments");
  label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormatter::make_group(std::string group, bool are_arguments,
                                      std::vector<const CLI::Option*> options) const {
  std::erase_if(options, [](const CLI::Option* one) { return one->get_description().empty(); });
  return Formatter::make_group(std::move(group), are_arguments, std::move(options));
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  std::string text = Formatter::make_option_opts(option);
  // More names than a line holds are for completion, and for the command that lists them.
  const std::size_t names = text.find(":{");
  if (names != std::string::npos && text.size() > left_column + right_column)
    text.erase(names, text.rfind('}') + 1 - names);
  return text;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return in_lines(option->get_description());
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  std::string name = "  " + command->get_name() + " ";
  if (name.size() < left_column) name.resize(left_column, ' ');
  return name +
         boost::algorithm::replace_all_copy(in_lines(command->get_description()), "\n",
                                            "\n" + std::string(left_column, ' ')) +
         "\n";
}

std::string HelpFormatter::make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const {
  const std::string below = Formatter::make_subcommands(app, mode);
  const CLI::App* program = app->get_parent();
  if (program == nullptr) return below;
  while (program->get_parent() != nullptr) program = program->get_parent();
  return below + make_group("Options of every command", false,
                            program->get_options([&](const CLI::Option* option) {
                              return option != program->get_help_ptr() &&
                                     option != program->get_version_ptr() &&
                                     option->get_group() == program->get_help_ptr()->get_group();
                            }));
}

}  // namespace oplus
