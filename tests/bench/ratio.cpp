// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/ratio.hpp"

#include <cmath>

#include "tests/bench/numbers.hpp"

namespace oplus {

std::string ratio_text(const Ratio& ratio) {
  return (ratio.is_lower_bound ? "> " : "") + three_digits(ratio.value);
}

std::optional<Ratio> time_ratio(const Report& report, const RowReport& row,
                                const std::string& engine, const std::string& base) {
  const Measurement* of_base = row.done(base);
  const Measurement* m = row.of(engine);
  if (of_base == nullptr || m == nullptr) return std::nullopt;
  if (m->outcome == Outcome::done) return Ratio{m->seconds / of_base->seconds, false};
  if (m->outcome == Outcome::over_limit)
    return Ratio{report.setting.limit / of_base->seconds, true};
  return std::nullopt;
}

std::optional<Ratio> memory_ratio(const Report&, const RowReport& row, const std::string& engine,
                                  const std::string& base) {
  const Measurement* of_base = row.done(base);
  const Measurement* m = row.of(engine);
  if (of_base == nullptr || m == nullptr) return std::nullopt;
  if (m->outcome != Outcome::done && m->outcome != Outcome::over_limit) return std::nullopt;
  return Ratio{m->peak_mb / of_base->peak_mb, m->outcome == Outcome::over_limit};
}

Ratio geometric_mean(const std::vector<Ratio>& ratios) {
  Ratio mean{0, false};
  for (const Ratio& ratio : ratios) {
    mean.value += std::log(ratio.value);
    mean.is_lower_bound = mean.is_lower_bound || ratio.is_lower_bound;
  }
  mean.value = std::exp(mean.value / static_cast<double>(ratios.size()));
  return mean;
}

}  // namespace oplus
