// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/terminal.hpp"

#include <iomanip>

#include "tests/bench/engine.hpp"
#include "tests/bench/numbers.hpp"

namespace oplus {

void write_head(std::ostream& out, const BenchRow& row) {
  out << row.name << ": " << row.what << std::endl;
}

std::string in_words(const Measurement& m) {
  switch (m.outcome) {
    case Outcome::done:
      return "done";
    case Outcome::over_limit:
      return m.note;
    case Outcome::crashed:
      return "crashed: " + m.note;
    case Outcome::failed:
      return "failed: " + m.note;
    case Outcome::not_taken:
      return m.note;
  }
  return "";
}

namespace {

/// Less than that, and other programs were in the way.
constexpr double well_busy = 0.95;

}  // namespace

void write_line(std::ostream& out, const Measurement& m) {
  out << "  " << std::left << std::setw(14) << m.engine << std::right;
  if (m.outcome != Outcome::done) {
    out << "  " << in_words(m) << std::endl;
    return;
  }
  out << std::setw(10) << three_digits(1000 * m.seconds) << " ms" << std::setw(10)
      << three_digits(m.peak_mb) << " MB";
  if (m.vertices > 0)
    out << std::setw(9) << with_thousands(m.vertices) << " vertices" << std::setw(8)
        << with_thousands(m.holes) << " holes";
  if (m.segments) out << std::setw(9) << with_thousands(*m.segments) << " segments";
  if (m.seconds_evaluated)
    out << "  (evaluated: " << three_digits(1000 * *m.seconds_evaluated) << " ms)";
  if (m.busy < well_busy) out << "  (a processor for " << three_digits(100 * m.busy) << " %)";
  out << std::endl;
}

void write_agreement(std::ostream& out, const RowReport& row) {
  const Agreement agreement = agreement_of(row);
  if (!agreement.disagreement.empty())
    out << "  DISAGREEMENT: " << agreement.disagreement << std::endl;
  if (agreement.exact == nullptr) return;
  for (const Measurement& m : row.measurements) {
    const BenchmarkedEngine* engine = find_benchmarked_engine(m.engine);
    if (m.outcome != Outcome::done || engine == nullptr || engine->arithmetic == Arithmetic::exact)
      continue;
    out << "  " << m.engine << ": area off by "
        << power_of_ten(relative_area_error(m, *agreement.exact)) << " of it, "
        << with_thousands(m.holes) << " holes of " << with_thousands(agreement.exact->holes)
        << std::endl;
  }
}

}  // namespace oplus
