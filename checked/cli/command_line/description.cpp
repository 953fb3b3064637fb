// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/description.hpp"

#include <algorithm>
#include <sstream>

namespace oplus {

namespace {

/// More names than a line holds are for completion, and for the command that lists them.
constexpr std::size_t most_listed = 12;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// CLI11's own names of types say how a value is kept, not what it is.
std::string name_of_value(const std::string& type) {
  if (type == "INT" || type == "UINT" || type == "FLOAT") return "N";
  return type;
}

/// CLI11 writes a validator into the type: "NAME:{a,b}", "N:INT in [1 - 1024]".
void add_validators(DescribedOption& option, const std::string& type) {
  const std::size_t open = type.find(":{");
  if (open != std::string::npos && type.back() == '}') {
    option.choices = split(type.substr(open + 2, type.size() - open - 3), ',');
    return;
  }
  const std::size_t range = type.find(" in [");
  if (range == std::string::npos || type.back() != ']') return;
  option.range = type.substr(range + 5, type.size() - range - 6);
  option.range.replace(option.range.find(" - "), 3, " to ");
}

template <typename Filter>
std::vector<DescribedOption> described_options(const CLI::App& app, const Filter& wanted) {
  std::vector<DescribedOption> result;
  for (const CLI::Option* option :
       app.get_options([&](const CLI::Option* o) { return wanted(*o); }))
    result.push_back(described(*option));
  return result;
}

bool is_argument(const CLI::Option& option) { return option.get_positional(); }
bool is_option(const CLI::Option& option) { return option.nonpositional(); }

bool contains_all(const std::string& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

}  // namespace

bool DescribedOption::takes_files() const {
  return choices.empty() && (value.starts_with("FILE") || value == "P Q" || value == "REPORT");
}

bool DescribedOption::takes_folders() const { return value == "DIR"; }

DescribedOption described(const CLI::Option& option) {
  DescribedOption result;
  if (option.get_positional()) {
    result.names = {option.get_name(true)};
  } else {
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  }
  result.what = option.get_description();
  result.required = option.get_required();
  for (const CLI::Option* other : option.get_excludes())
    result.excludes.push_back(other->get_name());
  std::sort(result.excludes.begin(), result.excludes.end());
  if (option.get_items_expected_max() == 0) return result;  // a flag
  const std::string type = option.get_type_name();
  result.value = name_of_value(type.substr(0, type.find(':')));
  add_validators(result, type);
  result.preset = option.get_default_str();
  if (result.preset == "[]" || result.preset == "\"\"") result.preset.clear();
  result.values = static_cast<std::size_t>(std::max(option.get_items_expected_min(), 1));
  result.repeats = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  return result;
}

DescribedProgram described(const CLI::App& program) {
  DescribedProgram result{program.get_name(),
                          program.get_description(),
                          described_options(program, is_option),
                          {},
                          program.get_footer()};
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    result.commands.push_back({command->get_name(), command->get_description(),
                               described_options(*command, is_argument),
                               described_options(*command, is_option), command->get_footer()});
  return result;
}

std::string full_description(const DescribedOption& option) {
  std::string more;
  const auto add = [&](const std::string& text) { more += (more.empty() ? "" : "; ") + text; };
  if (!option.choices.empty() && option.choices.size() <= most_listed &&
      !contains_all(option.what, option.choices))
    add("one of " + joined(option.choices));
  if (!option.range.empty()) add(option.range);
  if (!option.preset.empty()) add("default: " + option.preset);
  if (!option.excludes.empty()) add("not with " + joined(option.excludes));
  return more.empty() ? option.what : option.what + (option.what.empty() ? "(" : " (") + more + ")";
}

std::string short_description(const DescribedOption& option) {
  std::size_t end = option.what.size();
  for (const char* const mark : {": ", "; ", ". "}) end = std::min(end, option.what.find(mark));
  return option.what.substr(0, end);
}

bool is_for_every_command(const CLI::Option& option) {
  return option.nonpositional() && !option.check_lname("help") && !option.check_lname("version");
}

}  // namespace oplus
