// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/output.hpp"

#include <unistd.h>

#include <boost/algorithm/string/predicate.hpp>
#include <cerrno>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/output_file.hpp"
#include "reference/io/power_of_ten.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

std::string name_of(const std::string& path) { return path == "-" ? "standard output" : path; }

/// Where a path leads, so that two ways to write one file are recognized.
std::filesystem::path resolved(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
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
  const bool writable = !OutputFile::is_replaced(path) ? access(path.c_str(), W_OK) == 0
                                                       : access(folder.c_str(), W_OK) == 0;
  if (!writable)
    throw UsageError("cannot write " + path + ": " +
                     std::error_code(errno, std::generic_category()).message());
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
  output_grid(output);
  if (output.format) return *output.format;
  if (output.path == "-") return Format::wkt;
  if (const std::optional<Format> by_ending = format_of(output.path)) return *by_ending;
  throw UsageError("the ending of " + output.path +
                   " names no format: use .wkt, .dat, .geojson, .json or .wkb, or --format");
}

std::optional<OutputGrid> output_grid(const RoundingOptions& options) {
  if (options.grid && options.digits)
    throw UsageError("--digits N is short for --grid 10^-N; give one of the two");
  if (!options.grid && !options.digits) {
    if (options.side) throw UsageError("--side is for rounded output, with --grid or --digits");
    return std::nullopt;
  }
  const Side side = options.side.value_or(Side::nearest);
  if (options.digits)
    return OutputGrid{
        Rational(1) / Rational(power_of_ten(static_cast<std::size_t>(*options.digits))), side};
  return OutputGrid{positive_number("--grid", "a step", *options.grid), side};
}

namespace {

/// Throws UsageError where the format cannot hold the set (writing.hpp), and says what can.
void require_can_hold(Format format, const PlanarSet& set) {
  if (can_hold(format, set)) return;
  if (!set.is_unbounded)
    throw UsageError(
        ".dat cannot hold the dangling edges and isolated vertices of this set; write .wkt or "
        ".geojson");
  throw UsageError(
      can_hold(Format::dat, set)
          ? "the result is unbounded, which only .dat can hold; write .dat"
          : "the result is unbounded and has dangling edges or isolated vertices, which no "
            "format can hold; write its complement: with C, which `oplus complement P` writes, that of "
            "sum P Q --open is ifp C -Q, that of nfp P Q is ifp C Q, and that of ifp P Q is nfp C Q");
}

std::string said(const OutputGrid& grid, const RoundedSet& set) {
  const std::string distance = rounded_root(2 * set.bound * set.bound, true);
  std::string note = "rounded to multiples of " + to_string(grid.step) + ", ";
  note +=
      grid.side == Side::nearest ? "its boundary moved by at most " + distance
      : grid.side == Side::contain
          ? "it contains the exact one, and differs from it within " + distance + " of its boundary"
          : "it is contained in the exact one, and differs from it within " + distance +
                " of its boundary";
  const std::string changes = describe(set.changes);
  return changes.empty() ? note : note + "; " + changes;
}

/// Says that a text contains fractions that other programs do not read.
std::string note_on_fractions(Format format, const std::string& text) {
  const std::string_view fraction = first_fraction(text);
  if (fraction.empty() || format == Format::dat) return "";
  return "coordinates such as " + quote(fraction) +
         " are written as fractions p/q, which other programs do not read; --digits 15 writes "
         "decimals";
}

}  // namespace

void require_doubles(const Region& region, const PlanarSet& set) {
  if (const std::optional<Rational> value = not_a_double(region, set))
    throw UsageError("WKB holds doubles, and the coordinate " + to_string(*value) +
                     " is not exactly one; --grid 1/1048576 rounds to numbers that are");
}

OutputText output_text(const RegionOutput& output, Format format, const Region& region) {
  PlanarSet set;
  if (output_grid(output))
    set = canonical_sum(region);
  else
    set.is_unbounded = is_unbounded(region);
  return output_text(output, format, set, region, Boundary::closed);
}

OutputText output_text(const RegionOutput& output, Format format, const PlanarSet& set,
                       const Region& region, Boundary boundary) {
  const std::optional<OutputGrid> grid = output_grid(output);
  const RoundedSet rounded =
      grid ? oplus::rounded(set, boundary, grid->step, grid->side) : RoundedSet{};
  const PlanarSet& written_set = grid ? rounded.set : set;
  const Region& written_region = grid ? rounded.region : region;
  require_can_hold(format, written_set);
  if (format == Format::wkb) require_doubles(written_region, written_set);
  OutputText result{written(written_set, written_region, format), ""};
  result.note = grid && !rounded.is_exact ? said(*grid, rounded) : "";
  const std::string of_fractions = note_on_fractions(format, result.text);
  result.note += (result.note.empty() || of_fractions.empty() ? "" : "; ") + of_fractions;
  return result;
}

void write_output(const RegionOutput& output, const OutputText& text,
                  std::vector<OutputTo> others) {
  others.emplace_back(output.path, text.text);
  write_texts(others);
  if (!text.note.empty()) say_note(text.note);
}

void write_region(const RegionOutput& output, Format format, const Region& region) {
  write_output(output, output_text(output, format, region));
}

void write_set(const RegionOutput& output, Format format, const PlanarSet& set, Boundary boundary) {
  write_output(output, output_text(output, format, set, region_of(set), boundary));
}

void require_writable(std::vector<std::string> paths, const std::optional<std::string>& picture) {
  if (picture) paths.push_back(*picture);
  std::set<std::filesystem::path> seen;
  for (const std::string& path : paths) {
    require_writable(path);
    const std::filesystem::path place = path == "-" ? std::filesystem::path("-") : resolved(path);
    if (!seen.insert(place).second && (path == "-" || OutputFile::is_replaced(path)))
      throw UsageError("two outputs would go to " + name_of(path));
  }
  if (picture && OutputFile::is_replaced(*picture) &&
      !boost::algorithm::iends_with(*picture, ".svg"))
    throw UsageError("pictures are written as SVG; expected FILE.svg or -, not " + *picture);
}

}  // namespace oplus
