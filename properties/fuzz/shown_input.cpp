// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/shown_input.hpp"

#include <sstream>

#include "properties/fuzz/pair_of_bytes.hpp"
#include "properties/fuzz/slide_check.hpp"
#include "properties/runner/finding.hpp"
#include "properties/runner/shrinking.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// What is wrong with slide on a pair, or empty.
std::string fault_of(const Summands& summands) {
  try {
    check_slide(summands);
  } catch (const std::exception& e) {
    return e.what();
  }
  return {};
}

ShownInput shown_pair(Summands summands, const std::filesystem::path& folder) {
  ShownInput result;
  if (!fault_of(summands).empty()) {
    result.is_a_finding = true;
    summands = shrink(std::move(summands),
                      [](const Summands& smaller) { return !fault_of(smaller).empty(); });
  }
  const Finding files = write_finding(folder, "fuzz-slide", summands);
  std::ostringstream out;
  out << "P: " << wkt(summands.p) << "\nQ: " << wkt(summands.q) << "\nwritten to "
      << files.p.string() << " and " << files.q.string() << '\n'
      << (result.is_a_finding ? "finding: " + fault_of(summands) : "no finding") << '\n';
  result.text = out.str();
  return result;
}

}  // namespace

ShownInput shown(const FuzzTarget& target, std::string_view input,
                 const std::filesystem::path& folder) {
  if (&target == &slide_target) {
    auto pair = pair_of_bytes(input);
    if (!pair) return {"rejected: a summand that is not valid\n", false};
    return shown_pair(std::move(*pair), folder);
  }
  try {
    const bool reached = target.run(input) == FuzzOutcome::reached;
    return {reached ? "read; no finding\n" : "refused; no finding\n", false};
  } catch (const std::exception& e) {
    return {"finding: " + std::string(e.what()) + '\n', true};
  }
}

}  // namespace oplus
