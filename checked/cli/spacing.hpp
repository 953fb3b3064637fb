// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "checked/cli/shared_options.hpp"
#include "checked/operations/sum_of.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

/// How far Q is to be from what it must not overlap.
struct SpacingOptions {
  std::optional<std::string> distance;
  std::optional<std::string> error;
};

/// Adds `--spacing D` and `--spacing-error E`.
void add_spacing(const Command& command, SpacingOptions& spacing);

/// A polygon around the disc of that radius, at most the error beyond it (disc.hpp); none where no spacing was asked
/// for. Throws UsageError.
std::optional<Region> disc_of(const SpacingOptions& spacing);

/// Q and all points that are nearer to it than the spacing; some are farther away, by the error at most. Where this,
/// moved, only touches P, Q is not nearer to P than the spacing.
ReadSet spaced(const ReadSet& q, const Region& disc, const SumOf& sum);

}  // namespace oplus
