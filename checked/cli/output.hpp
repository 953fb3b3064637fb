// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checked/cli/command_line/outputs.hpp"
#include "checked/rounding/rounding.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

/// How what is written is rounded, as the command line says it.
struct RoundingOptions {
  std::optional<std::string> grid;  ///< the step
  std::optional<int> digits;        ///< short for the step 10^-digits
  std::optional<Side> side;         ///< nearest if empty
};

/// Where a region or a sum is written, and how.
struct RegionOutput : RoundingOptions {
  std::string path = "-";  ///< "-" is standard output
  std::optional<Format> format;
};

/// The grid that the output is rounded to.
struct OutputGrid {
  Rational step;
  Side side;
};

/// The grid that was asked for; none if the output is exact. Throws UsageError.
std::optional<OutputGrid> output_grid(const RoundingOptions& options);

/// The format to write in: the one asked for, else by the ending of the path; WKT on standard
/// output. Throws UsageError for an ending that names no format, and for an invalid grid: to be called before
/// anything is computed.
Format output_format(const RegionOutput& output);

/// What is to be written, and what is to be known of it.
struct OutputText {
  std::string text;
  std::string note;  ///< a line; empty where there is nothing to say
};

/// The text of a region or a set, exactly or rounded. Throws UsageError where the format cannot hold it.
OutputText output_text(const RegionOutput& output, Format format, const Region& region);
OutputText output_text(const RegionOutput& output, Format format, const PlanarSet& set,
                       const Region& region, Boundary boundary);

/// Throws UsageError where WKB cannot hold these.
void require_doubles(const Region& region, const PlanarSet& set);

/// Writes it, and other texts with it, and says what is to be known of it. Throws UsageError where it cannot
/// write; then no file has appeared.
void write_output(const RegionOutput& output, const OutputText& text,
                  std::vector<OutputTo> others = {});

/// All of it at once.
void write_region(const RegionOutput& output, Format format, const Region& region);
void write_set(const RegionOutput& output, Format format, const PlanarSet& set, Boundary boundary);

/// Throws UsageError where an output could not be written, two would be written to one place, or a
/// picture's path does not end in .svg (in capitals or not), so that it is known before anything is
/// computed or written. "-" is standard output; it and devices may get pictures.
void require_writable(std::vector<std::string> paths,
                      const std::optional<std::string>& picture = std::nullopt);

}  // namespace oplus
