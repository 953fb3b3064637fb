// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/spacing.hpp"

#include "checked/cli/input.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/operations/disc.hpp"
#include "reference/chains/region_of.hpp"

namespace oplus {

void add_spacing(const Command& command, SpacingOptions& spacing) {
  command.option(
      "--spacing D", spacing.distance,
      "keep Q at a distance: nfp is also where Q is nearer to P than D, and ifp only where it is not "
      "nearer than D to what is outside of P. By a polygon around the disc of radius D, so that Q is "
      "never nearer than D where it is allowed to be");
  command.option("--spacing-error E", spacing.error,
                 "by how much the polygon may be larger than the disc, D/100 by default");
}

std::optional<Region> disc_of(const SpacingOptions& spacing) {
  if (!spacing.distance) {
    if (spacing.error) throw UsageError("--spacing-error is for --spacing");
    return std::nullopt;
  }
  const Rational radius = positive_number("--spacing", "a distance", *spacing.distance);
  return disc_polygon(radius, DiscSide::outside,
                      spacing.error
                          ? positive_number("--spacing-error", "a distance", *spacing.error)
                          : Rational(radius / 100));
}

ReadSet spaced(const ReadSet& q, const Region& disc, const SumOf& sum) {
  const PlanarSet grown = result_of(operation_called("sum"), q, {disc, {}, {}, {}}, sum);
  return {region_of(grown), {}, {}, {}};
}

}  // namespace oplus
