// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "checked/cli/exit_code.hpp"
#include "checked/cli/output.hpp"
#include "checked/cli/program.hpp"
#include "checked/engine.hpp"
#include "checked/operations/sum_of.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/rational.hpp"
#include "reference/io/overlaps.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

/// Adds `--grid STEP`, `--digits N` and `--side NAME`.
void add_rounding(const Command& command, RoundingOptions& rounding);

/// Adds these, `-o FILE` and `--format wkt|dat|geojson|wkb`. `what` is what is written.
void add_output(const Command& command, RegionOutput& output, const std::string& what);

inline constexpr const char* default_angle_error = "0.001";

/// Adds `--angle-error E` for rotations.
Option add_angle_error(const Command& command, std::string& error);

/// In degrees, above 0. Throws UsageError.
Rational angle_error(const std::string& text);

/// Adds `--union`. `what` is which inputs it is for.
void add_union(const Command& command, Overlaps& overlaps, const std::string& what);

/// Adds `--threads N`. `what` is whose they are: " of ...".
void add_threads(const Command& command, std::optional<unsigned>& threads, const std::string& what);

/// As many threads as were asked for; by default, and for 0, one per core.
unsigned number_of(const std::optional<unsigned>& threads);

/// The same of an engine. Throws UsageError where it has none, and some were asked for.
unsigned threads_of(const Engine& engine, const std::optional<unsigned>& threads);

/// Returns "computing a sum of 30 and 40 vertices" and, where that makes it slow, how long coordinates are.
std::string step_of_sum(const Region& p, const Region& q);

/// Adds `--certificate FILE`.
void add_certificate(const Command& command, std::optional<std::string>& certificate,
                     const std::string& what);

/// Throws UsageError where a certificate of a set is asked for that is rounded when it is written.
void require_certifiable(const std::optional<std::string>& certificate, const RegionOutput& output);

/// Adds `--open`.
void add_open(const Command& command, Boundary& boundary, const std::string& what);

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

/// What the program offers, the default first: the engines (checked/engines/engines.hpp), then the oracle.
const std::vector<Engine>& engines_and_oracle();

}  // namespace oplus
