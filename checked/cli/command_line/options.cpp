// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <optional>
#include <utility>

namespace oplus {

Option Option::required() const { return Option(option_->required()); }

Option Option::one_of(const std::vector<std::string>& names) const {
  return Option(option_->check(CLI::IsMember(names)));
}

Option Option::one_of(const std::vector<std::string>& names,
                      const std::function<void(const std::string&)>& check) const {
  const auto refuse = [check](const std::string& name) {
    check(name);
    return std::string();
  };
  return Option(
      option_->check(CLI::Validator(refuse, "{" + boost::algorithm::join(names, ",") + "}")));
}

Option Option::range(int least, int most) const {
  return Option(option_->check(CLI::Range(least, most)));
}

Option Option::range(std::size_t least, std::size_t most) const {
  return Option(option_->check(CLI::Range(least, most)));
}

Option Option::range(double least, double most) const {
  return Option(option_->check(CLI::Range(least, most)));
}

Option Option::positive() const { return Option(option_->check(CLI::PositiveNumber)); }

Option Option::existing_file() const { return Option(option_->check(CLI::ExistingFile)); }

Option Option::existing_folder() const { return Option(option_->check(CLI::ExistingDirectory)); }

Option Option::values(int count) const { return Option(option_->expected(count)); }

Option Option::values_each_time(int count) const { return Option(option_->type_size(count)); }

Option Option::separated_by_commas() const {
  return Option(option_->delimiter(',')->allow_extra_args(false));
}

Option Option::needs(const Option& other) const { return Option(option_->needs(other.option_)); }

Option Option::excludes(const Option& other) const {
  return Option(option_->excludes(other.option_));
}

Option Option::default_shown() const { return Option(option_->capture_default_str()); }

Option Option::default_shown(const std::string& value) const {
  return Option(option_->default_str(value));
}

Option Option::at_once() const { return Option(option_->trigger_on_parse()); }

namespace {

/// What adds an option is called with its names; behind a space stands what help calls the value.
template <typename Add>
Option named(const std::string& text, Add add) {
  const std::size_t space = text.find(' ');
  CLI::Option* const option = add(text.substr(0, space));
  if (space != std::string::npos) option->type_name(text.substr(space + 1));
  return Option(option);
}

}  // namespace

template <typename Value>
Option Command::option(const std::string& names, Value& value, const std::string& what) const {
  return named(names,
               [&](const std::string& each) { return command_->add_option(each, value, what); });
}

#define OPLUS_OPTION(Value) \
  template Option Command::option(const std::string&, Value&, const std::string&) const
OPLUS_OPTION(std::string);
OPLUS_OPTION(std::optional<std::string>);
OPLUS_OPTION(int);
OPLUS_OPTION(std::optional<int>);
OPLUS_OPTION(unsigned);
OPLUS_OPTION(std::optional<unsigned>);
OPLUS_OPTION(std::size_t);
OPLUS_OPTION(std::optional<std::size_t>);
OPLUS_OPTION(double);
OPLUS_OPTION(std::vector<std::string>);
OPLUS_OPTION(std::vector<std::vector<std::string>>);
#undef OPLUS_OPTION

Option Command::option_taken_by(const std::string& names,
                                std::function<void(const std::string&)> take,
                                const std::string& what) const {
  return named(names, [&](const std::string& each) {
    return command_->add_option_function<std::string>(each, std::move(take), what);
  });
}

Option Command::flag(const std::string& names, bool& value, const std::string& what) const {
  return Option(command_->add_flag(names, value, what));
}

Option Command::flag(const std::string& names, std::function<void()> set,
                     const std::string& what) const {
  return Option(command_->add_flag_callback(names, std::move(set), what));
}

void Command::remove(const std::string& option) const {
  command_->remove_option(command_->get_option(option));
}

std::vector<std::string> Command::given(const std::vector<std::string>& without) const {
  std::vector<std::string> words;
  for (const CLI::Option* const option : command_->get_options()) {
    if (option->count() == 0 || std::ranges::count(without, option->get_name()) > 0) continue;
    words.push_back(option->get_name());
    for (const std::string& value : option->results()) words.push_back(value);
  }
  return words;
}

void Command::footer(const std::string& text) const { command_->footer(text); }

Command Program::add(const std::string& name, const std::string& what,
                     std::function<int()> its_work) {
  CLI::App& command = *app.add_subcommand(name, what);
  // CLI11 calls this after what the command's own commands ask for.
  command.callback([this, its_work, &command] {
    if (command.get_subcommands().empty()) work = its_work;
  });
  return Command(command);
}

Command Program::add_below(const Command& above, const std::string& name, const std::string& what,
                           std::function<int()> its_work) {
  CLI::App& command = *above.command_->add_subcommand(name, what);
  command.callback([this, its_work] { work = its_work; });
  for (CLI::Option* const option : above.command_->get_options({})) command.excludes(option);
  return Command(command);
}

Command Program::command(const std::string& name) const {
  return Command(*app.get_subcommand(name));
}

}  // namespace oplus
