// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/finding.hpp"

#include <iomanip>
#include <sstream>

#include "properties/runner/property_run.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

Finding write_finding(const std::filesystem::path& folder, const std::string& statement,
                      const Summands& summands) {
  std::filesystem::create_directories(folder);
  const std::string p = written(summands.p, Format::dat), q = written(summands.q, Format::dat);
  std::ostringstream name;
  name << statement << '-' << std::hex << std::setfill('0') << std::setw(16) << seed_of(p + q, 0);
  const Finding finding{folder / (name.str() + "-p.dat"), folder / (name.str() + "-q.dat")};
  write_file(finding.p.string(), p);
  write_file(finding.q.string(), q);
  return finding;
}

std::string for_shell(const std::string& text) {
  const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string replay_line(const std::string& statement, const Finding& finding) {
  return "oplus-check properties --theorem " + statement + " --pair " + for_shell(finding.p) + " " +
         for_shell(finding.q);
}

}  // namespace oplus
