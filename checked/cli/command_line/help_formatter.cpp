// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/help_formatter.hpp"

#include <sstream>

#include "checked/cli/command_line/description.hpp"

namespace oplus {

namespace {

constexpr std::size_t left_column = 28;
constexpr std::size_t longest_line = 100;

/// "  left    right", the right side broken into lines; beneath a left side that is too long.
std::string entry(const std::string& left, const std::string& right) {
  std::string text = "  " + left;
  std::size_t column = text.size();
  if (column + 1 > left_column) {
    text += "\n";
    column = 0;
  }
  text += std::string(left_column - column, ' ');
  column = left_column;
  std::istringstream words(right);
  for (std::string word; words >> word;) {
    if (column > left_column && column + 1 + word.size() > longest_line) {
      text += "\n" + std::string(left_column, ' ');
      column = left_column;
    }
    if (column > left_column) {
      text += " ";
      ++column;
    }
    text += word;
    column += word.size();
  }
  return text + "\n";
}

std::string left_side(const DescribedOption& option) {
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + name;
  return option.value.empty() ? text : text + " " + option.value;
}

}  // namespace

HelpFormatter::HelpFormatter() {
  column_width(left_column);
  label("Positionals", "Arguments");
  label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  const DescribedOption shown = described(*option);
  return entry(is_positional ? shown.names.front() : left_side(shown), full_description(shown));
}

std::string HelpFormatter::make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const {
  std::string text = CLI::Formatter::make_subcommands(app, mode);
  const std::string title = "\nSubcommands:\n";  // CLI11's own, which no label replaces
  if (const std::size_t at = text.find(title); at != std::string::npos)
    text.replace(at, title.size(), "\nCommands:\n");
  if (app->get_parent() == nullptr) return text;
  text += "\nOptions of every command:\n";
  for (const CLI::Option* option : app->get_parent()->get_options(
           [](const CLI::Option* o) { return is_for_every_command(*o); }))
    text += make_option(option, false);
  return text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

}  // namespace oplus
