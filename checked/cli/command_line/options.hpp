// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace oplus {

/// The options of a program's commands. CLI11 reads them, and is compiled in few files: its headers cost
/// more than all else that a command includes.

/// A text of each item: its member or what a function says of it.
template <typename Items, typename Text>
std::vector<std::string> texts(const Items& items, Text text) {
  std::vector<std::string> all;
  for (const auto& item : items) all.emplace_back(std::invoke(text, item));
  return all;
}

/// These, one after another with the separator between them.
template <typename Items, typename Text>
std::string joined(const Items& items, Text text, const std::string& separator) {
  std::string all;
  for (const std::string& each : texts(items, text)) all += (all.empty() ? "" : separator) + each;
  return all;
}

/// An option, or an argument, of a command, while it is described. Each function returns the same option.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required() const;

  /// Values other than these are refused. Help and completion show them.
  Option one_of(const std::vector<std::string>& names) const;

  /// The same, where `check` throws UsageError for what it refuses.
  Option one_of(const std::vector<std::string>& names,
                const std::function<void(const std::string&)>& check) const;

  Option range(int least, int most) const;
  Option range(std::size_t least, std::size_t most) const;
  Option range(double least, double most) const;
  Option positive() const;
  Option existing_file() const;
  Option existing_folder() const;

  /// Takes that many values, once; or each time it is given; or one, which commas separate into several.
  Option values(int count) const;
  Option values_each_time(int count) const;
  Option separated_by_commas() const;

  Option needs(const Option& other) const;
  Option excludes(const Option& other) const;

  /// Shows the default in help: what the variable has now, or this.
  Option default_shown() const;
  Option default_shown(const std::string& value) const;

  /// Takes effect where it stands, before the command line is read to its end.
  Option at_once() const;

 private:
  CLI::Option* option_;
};

/// A command, while it is described. What it is read into must live as long as the program.
class Command {
 public:
  explicit Command(CLI::App& command) : command_(&command) {}

  /// Adds an option "-o,--output FILE", or an argument "P FILE"; help calls its value FILE, by default as its
  /// type, such as UINT. One without a description is shown by neither help nor completion. Value: string, int,
  /// unsigned, std::size_t, optionals of these, double, vectors of strings and of vectors of strings.
  template <typename Value>
  Option option(const std::string& names, Value& value, const std::string& what) const;

  /// The same, where a function takes the text.
  Option option_taken_by(const std::string& names, std::function<void(const std::string&)> take,
                         const std::string& what) const;

  template <typename Path>
  Option file(const std::string& names, Path& path, const std::string& what) const {
    return option(names + " FILE", path, what);
  }

  /// An option whose values have names. Help calls them NAME by default.
  template <typename Value, typename Chosen>
  Option choice(const std::string& names, Chosen& chosen,
                const std::map<std::string, Value>& values, const std::string& what) const {
    const auto take = [&chosen, values](const std::string& name) { chosen = values.at(name); };
    return option_taken_by(names.find(' ') < names.size() ? names : names + " NAME", take, what)
        .one_of(texts(values, &std::map<std::string, Value>::value_type::first));
  }

  Option flag(const std::string& names, bool& value, const std::string& what) const;
  Option flag(const std::string& names, std::function<void()> set, const std::string& what) const;

  void remove(const std::string& option) const;

  /// The options and arguments that were given, but for some of these names: each name, and its values.
  std::vector<std::string> given(const std::vector<std::string>& without) const;

  /// What help says below the options.
  void footer(const std::string& text) const;

 private:
  friend struct Program;
  CLI::App* command_;
};

/// A command, and what its options are read into.
template <typename Options>
struct CommandWith {
  Command command;
  Options& options;
};

/// A program, while its commands are described.
struct Program {
  CLI::App& app;

  /// The name of the only command that is needed, since describing all takes longer than a small sum; else none.
  std::optional<std::string> only = std::nullopt;

  /// Whether a command of this name is to be described.
  bool needs(std::string_view name) const { return !only || *only == name; }

  /// What the command that is asked for does, after all of the command line is understood. Returns the exit
  /// code.
  std::function<int()> work = {};

  Command add(const std::string& name, const std::string& what, std::function<int()> its_work);

  /// A command of a command, which takes none of the options that `above` has by now.
  Command add_below(const Command& above, const std::string& name, const std::string& what,
                    std::function<int()> its_work);

  template <typename Code, typename Parameter>
  CommandWith<std::remove_cvref_t<Parameter>> add(const std::string& name, const std::string& what,
                                                  Code (*its_work)(Parameter)) {
    const auto options = std::make_shared<std::remove_cvref_t<Parameter>>();
    return {add(name, what, [=] { return static_cast<int>(its_work(*options)); }), *options};
  }

  Command command(const std::string& name) const;
};

}  // namespace oplus
