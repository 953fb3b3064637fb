// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/row.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/io/number.hpp"
#include "tests/bench/engine.hpp"
#include "tests/bench/numbers.hpp"

namespace oplus {

std::string in_words(const Measurement& m) {
  using Ending = Measurement::Ending;
  switch (m.outcome) {
    case Ending::done:
      return "done";
    case Ending::out_of_memory:
      return "out of memory";
    case Ending::crashed:
      return "crashed: " + m.note;
    case Ending::failed:
      return "failed: " + m.note;
    case Ending::over_limit:
    case Ending::unsupported:
      return m.note;
  }
  return "";
}

const Measurement* Row::of(const std::string& engine) const {
  const auto found = std::ranges::find(measurements, engine, &Measurement::engine);
  return found == measurements.end() ? nullptr : &*found;
}

const Measurement* Row::done(const std::string& engine) const {
  const Measurement* found = of(engine);
  return found != nullptr && found->is_done() ? found : nullptr;
}

namespace {

Rational area_of(const Measurement& m) {
  NumberFault fault;
  const std::optional<Rational> area = parse_number(m.area, fault);
  if (!area) throw std::invalid_argument(m.engine + ": invalid area: " + m.area);
  return *area;
}

}  // namespace

std::optional<double> Row::number(const std::string& path) const {
  const std::size_t slash = path.find('/');
  if (slash != std::string::npos) {
    const auto dividend = number(path.substr(0, slash));
    const auto divisor = number(path.substr(slash + 1));
    return dividend && divisor ? std::optional(*dividend / *divisor) : std::nullopt;
  }
  const auto own = numbers.find(path);
  if (own != numbers.end()) return own->second;
  const std::size_t dot = path.find('.');
  const Measurement* exact = agreement_of(*this).exact;
  const Measurement* m = dot == std::string::npos ? exact : done(path.substr(0, dot));
  if (m == nullptr) return std::nullopt;
  if (!path.ends_with("area_error")) return m->number(path.substr(dot + 1));
  if (exact == nullptr || exact->area.empty() || m->area.empty()) return std::nullopt;
  const Rational area = area_of(*exact);
  const Rational error = area_of(*m) - area;
  return path.ends_with(".area_error") ? error.get_d() : Rational(error / area).get_d();
}

Rows rows_where(Rows rows, const std::function<bool(const Row&)>& is_one) {
  std::erase_if(rows, std::not_fn(is_one));
  return rows;
}

Rows rows_for(const Rows& rows, Subject subject) {
  return rows_where(rows, [=](const Row& row) { return row.subject == subject; });
}

Agreement agreement_of(const Row& row) {
  Agreement agreement;
  std::map<std::string, std::string> engines_by_digest;
  for (const Measurement& m : row.measurements) {
    if (!m.is_done() || m.digest.empty()) continue;
    ++agreement.compared;
    if (agreement.exact == nullptr) agreement.exact = &m;
    std::string& names = engines_by_digest[m.digest];
    names += (names.empty() ? "" : ", ") + m.engine;
  }
  if (engines_by_digest.size() > 1) {
    for (const auto& [digest, names] : engines_by_digest)
      agreement.disagreement += (agreement.disagreement.empty() ? "" : " against ") + names;
  }
  return agreement;
}

std::vector<std::string> faults_of(const Row& row) {
  std::vector<std::string> faults;
  const std::string disagreement = agreement_of(row).disagreement;
  if (!disagreement.empty()) faults.push_back(row.name + ": " + disagreement + " disagree");
  for (const Measurement& m : row.measurements) {
    const bool lost =
        m.outcome == Measurement::Ending::crashed || m.outcome == Measurement::Ending::failed;
    const BenchEngine* engine = find_bench_engine(row.subject, m.engine);
    if (lost && engine != nullptr && engine->is_ours)
      faults.push_back(row.name + ": " + m.engine + ' ' + in_words(m));
  }
  return faults;
}

std::string ratio_text(const Ratio& ratio) {
  return (ratio.is_lower_bound ? "> " : "") + three_digits(ratio.value);
}

std::optional<Ratio> ratio(const Row& row, const std::string& number, const std::string& engine,
                           const std::string& base, double limit) {
  const Measurement* m = row.of(engine);
  const std::optional<double> of_base = row.number(base + '.' + number);
  if (m == nullptr || !of_base) return std::nullopt;
  const bool ended = m->outcome == Measurement::Ending::over_limit;
  if (!m->is_done() && !ended) return std::nullopt;
  const double of_engine = ended && number == "seconds" ? limit : m->numbers.at(number);
  return Ratio{of_engine / *of_base, ended};
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
