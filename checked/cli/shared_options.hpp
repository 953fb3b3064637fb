// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/range/adaptor/transformed.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "checked/cli/output.hpp"
#include "checked/cli/subcommands.hpp"
#include "reference/definitions/minkowski_sum.hpp"
#include "reference/definitions/rational.hpp"
#include "reference/io/overlaps.hpp"

namespace oplus {

/// A subcommand and what its options are read into, which lives as long as the program.
template <typename Options>
struct Subcommand {
  CLI::App& command;
  Options& options;
};

/// Adds a subcommand, which sets `chosen` to its work where it is the one asked for.
template <typename Options>
Subcommand<Options> add_subcommand(CLI::App& program, Action& chosen, const std::string& name,
                                   const std::string& what, ExitCode (*work)(const Options&)) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *program.add_subcommand(name, what);
  command.callback([=, &chosen] { chosen = [=] { return work(*options); }; });
  return {command, *options};
}

/// The texts of the items, one after another with the separator between them.
template <typename Items, typename Text>
std::string joined(const Items& items, Text text, const std::string& separator) {
  return boost::algorithm::join(items | boost::adaptors::transformed(text), separator);
}

/// Adds an option or an argument that is the name of a file.
template <typename Path>
CLI::Option* add_file(CLI::App& command, const std::string& name, Path& path,
                      const std::string& what) {
  return command.add_option(name, path, what)->type_name("FILE");
}

/// Adds an option whose values have these names, which are read into `chosen`.
template <typename Value, typename Chosen>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Chosen& chosen,
                        const std::map<std::string, Value>& values, const std::string& what) {
  return command
      .add_option_function<std::string>(
          name, [&chosen, values](const std::string& text) { chosen = values.at(text); }, what)
      ->check(CLI::IsMember(values))
      ->type_name("NAME");
}

/// Adds `--grid STEP`, `--digits N` and `--side NAME`.
void add_rounding(CLI::App& command, RoundingOptions& rounding);

/// Adds these, `-o FILE` and `--format wkt|dat|geojson|wkb`. `what` is what is written.
void add_output(CLI::App& command, RegionOutput& output, const std::string& what);

inline constexpr const char* default_angle_error = "0.001";

/// Adds `--angle-error E` for rotations.
CLI::Option* add_angle_error(CLI::App& command, std::string& error);

/// In degrees, above 0. Throws UsageError.
Rational angle_error(const std::string& text);

/// Adds `--union`. `what` is which inputs it is for.
void add_union(CLI::App& command, Overlaps& overlaps, const std::string& what);

/// Adds `--threads N`. `what` is whose they are: " of ...".
void add_threads(CLI::App& command, std::optional<unsigned>& threads, const std::string& what);

/// As many threads as were asked for; by default one per core.
unsigned number_of(const std::optional<unsigned>& threads);

/// Adds `--open`.
void add_open(CLI::App& command, Boundary& boundary, const std::string& what);

/// The same of a command that takes a set R, as it is.
void add_open_set(CLI::App& command, Boundary& boundary);

}  // namespace oplus
