// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/output.hpp"

#include <unistd.h>

#include <boost/algorithm/string/predicate.hpp>
#include <cerrno>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "checked/cli/command_line/program_frame.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

namespace {

std::string name_of(const std::string& path) { return path == "-" ? "standard output" : path; }

/// Where a path leads, so that two ways to write one file are recognized.
std::filesystem::path resolved(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
}

/// Whether the path names a device or a pipe, which is written to and never replaced.
bool is_special(const std::string& path) {
  std::error_code failed;
  const std::filesystem::file_status status = std::filesystem::status(path, failed);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

void require_writable(const std::string& path) {
  if (path == "-") return;
  if (path.empty()) throw UsageError("an output file needs a name");
  std::error_code failed;
  const std::filesystem::path folder =
      std::filesystem::absolute(std::filesystem::path(path), failed).parent_path();
  if (std::filesystem::is_directory(path, failed))
    throw UsageError("cannot write " + path + ": it is a folder");
  if (!std::filesystem::is_directory(folder, failed))
    throw UsageError("cannot write " + path + ": there is no folder " + folder.string());
  // A file is replaced as a whole, so its folder must be writable; a device is not replaced.
  const bool writable =
      is_special(path) ? access(path.c_str(), W_OK) == 0 : access(folder.c_str(), W_OK) == 0;
  if (!writable)
    throw UsageError("cannot write " + path + ": " +
                     std::error_code(errno, std::generic_category()).message());
}

/// Why reading the text would fail; empty if it would not.
std::string defect_in(const std::string& text) {
  try {
    read_sum(text, "the output");
    return "";
  } catch (const InvalidInput& error) {
    return error.wrong();
  }
}

/// The first fraction in the text of a region; empty if there is none.
std::string_view first_fraction(std::string_view text) {
  constexpr std::string_view of_fractions = "-0123456789/";
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return "";
  const std::size_t start = text.find_last_not_of(of_fractions, slash) + 1;
  return text.substr(start, text.find_first_not_of(of_fractions, slash) - start);
}

}  // namespace

Format output_format(const RegionOutput& output) {
  if (output.format) return *output.format;
  if (output.path == "-") return Format::wkt;
  if (const std::optional<Format> by_ending = format_of(output.path)) return *by_ending;
  throw UsageError("the ending of " + output.path +
                   " names no format: use .wkt, .dat, .geojson or .json, or --format");
}

void write_region(const RegionOutput& output, Format format, const std::string& text) {
  write_text(output.path, text);
  say_what_was_written(output, format, text);
}

void say_what_was_written(const RegionOutput& output, Format format, const std::string& text) {
  if (speech().quiet) return;
  if (output.digits) {
    const std::string rounded =
        "the output is rounded to " +
        counted(static_cast<std::size_t>(*output.digits), "decimal", "decimals");
    const std::string defect = defect_in(text);
    say_note(defect.empty() ? rounded + "; without --digits it is exact"
                            : rounded + " and no longer valid: " + defect +
                                  "; use more decimals, or leave out --digits");
  } else if (const std::string_view fraction = first_fraction(text);
             !fraction.empty() && format != Format::dat) {
    say_note("coordinates such as " + quote(fraction) +
             " are written as fractions p/q, which other programs do not read; --digits 15 writes "
             "decimals");
  }
}

void require_writable(std::vector<std::string> paths, const std::optional<std::string>& picture) {
  if (picture) paths.push_back(*picture);
  std::set<std::filesystem::path> seen;
  for (const std::string& path : paths) {
    require_writable(path);
    const std::filesystem::path place = path == "-" ? std::filesystem::path("-") : resolved(path);
    if (!seen.insert(place).second && !is_special(path))
      throw UsageError("two outputs would go to " + name_of(path));
  }
  if (picture && *picture != "-" && !is_special(*picture) &&
      !boost::algorithm::iends_with(*picture, ".svg"))
    throw UsageError("pictures are written as SVG; expected FILE.svg or -, not " + *picture);
}

}  // namespace oplus
