// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/finding.hpp"

#include <iomanip>
#include <sstream>

#include "reference/io/writing.hpp"

namespace oplus {

std::uint64_t seed_of(const std::string& id, std::uint64_t seed) {
  // FNV-1a, spelled out because std::hash differs between compilers.
  std::uint64_t hash = 14695981039346656037U;
  const auto mix = [&](std::uint64_t byte) { hash = (hash ^ byte) * 1099511628211U; };
  for (const char c : id) mix(static_cast<unsigned char>(c));
  for (int shift = 0; shift < 64; shift += 8) mix((seed >> shift) & 0xff);
  return hash;
}

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
