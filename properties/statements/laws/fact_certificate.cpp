// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "checked/certificates/certificate.hpp"
#include "properties/compare/certified_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  Outcome outcome;
  const auto& [p, q] = summands;
  if (!can_certify()) return outcome.fail("oplus-certified was not built");
  const ProcessLimits limits{.is_quiet = true};
  const PlanarSet sum = oracle_sums(p, q).closed;
  const Region region = region_of(sum);
  const std::string certificate = certificates::written(certificates::certificate(p, q, region));
  const EndedProcess ended = checked_certificate(p, q, region, certificate, limits);
  if (!says_certified(ended))
    return outcome.fail("the oracle's sum is not certified: " + ended.output + ended.errors);

  const auto accepts = [&](const Region& given) {
    ++outcome.counts["wrong sums"];
    return says_certified(checked_certificate(p, q, given, certificate, limits));
  };
  if (accepts(translated(region, {1, 0}))) return outcome.fail("a translated sum is certified");
  for (std::size_t i = 0; i < sum.holes.size(); ++i) {
    PlanarSet filled = sum;
    filled.holes.erase(filled.holes.begin() + static_cast<std::ptrdiff_t>(i));
    if (accepts(region_of(filled)))
      return outcome.fail("a sum without one of its holes is certified");
    try {
      certificates::certificate(p, q, region_of(filled));
      return outcome.fail("a certificate is found for a sum without one of its holes");
    } catch (const certificates::PointOutsideSum&) {
      ++outcome.counts["no certificate"];
    }
  }
  return outcome;
}

const Registered registered({
    .id = "fact-certificate",
    .sources = {{"tight", 4, 6},
                {"grid", 8, 3},
                {"holes", 4, 2},
                {"components", 3, 1},
                {"islands", 1, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 10},
                 {"reflex vertices", 10},
                 {"parallel edges", 40},
                 {"overlapping segments", 5}},
    .kills = {"cells-stick-out-of-sums", "cuts-swap-their-sides"},
    .cases = 100,
    .check = check,
});

}  // namespace

}  // namespace oplus
