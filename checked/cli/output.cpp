// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/output.hpp"

#include <unistd.h>

#include <boost/algorithm/string/predicate.hpp>
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>

#include "checked/cli/usage_error.hpp"

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

}  // namespace

Format output_format(const std::optional<Format>& asked_for, const std::string& path) {
  if (asked_for) return *asked_for;
  if (path == "-") return Format::wkt;
  if (const std::optional<Format> by_ending = format_of(path)) return *by_ending;
  throw UsageError("the ending of " + path +
                   " names no format: use .wkt, .dat, .geojson or .json, or --format");
}

void require_svg(const std::string& path) {
  if (path != "-" && !is_special(path) && !boost::algorithm::iends_with(path, ".svg"))
    throw UsageError("pictures are written as SVG; expected FILE.svg or -, not " + path);
}

void require_writable(const std::vector<std::string>& paths) {
  std::set<std::filesystem::path> seen;
  for (const std::string& path : paths) {
    require_writable(path);
    const std::filesystem::path place = path == "-" ? std::filesystem::path("-") : resolved(path);
    if (!seen.insert(place).second && !is_special(path))
      throw UsageError("two outputs would go to " + name_of(path));
  }
}

}  // namespace oplus
