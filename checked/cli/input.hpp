// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "checked/operations/operations.hpp"
#include "checked/statistics.hpp"
#include "reference/definitions/claimed_sum.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/unchecked_input.hpp"

namespace oplus {

/// What reading took.
struct ReadingTimes {
  Seconds reading{};
  Seconds validation{};
};

/// What is added to a refusal of components that overlap.
inline constexpr const char* hint_at_union = "add --union to take their union";

/// Read a file ("-" is standard input); say on standard error what reading repaired, and on a terminal
/// how far it is where it takes longer than a second. Add to the times, if given. Throw InvalidInput.
/// Where components may overlap, the region is their union; where not, UsageError names --union.
Region read_summand(const std::string& path, ReadingTimes* times = nullptr,
                    Extent extent = Extent::bounded, Overlaps overlaps = Overlaps::refused);
ReadSet read_summand_set(const std::string& path, ReadingTimes* times = nullptr,
                         Overlaps overlaps = Overlaps::refused);
PlanarSet read_canonical_sum(const std::string& path);
ClaimedSum read_unchecked_sum(const std::string& path);
UncheckedInput read_unchecked_region(const std::string& path);

/// Makes the region the union of its components, where they may overlap.
void unite(Region& region, Overlaps overlaps);

/// Whether a set is a region alone, without segments and points.
bool is_region(const ReadSet& set);

/// The closed set that a summand is: the union of all its parts, in canonical form.
PlanarSet union_in(const ReadSet& set);

/// What the operation makes of two sets, with these sums.
PlanarSet result_of(const Operation& operation, const ReadSet& p, const ReadSet& q,
                    const SumOf& sum);

/// A sum or another set, of which nothing is known but that its region is valid: its segments are its dangling
/// edges, wherever they are, and its points its isolated vertices.
PlanarSet set_in(const ReadSet& read);

/// Throws UsageError where standard input is named more than once.
void require_one_standard_input(const std::vector<std::string>& paths);

}  // namespace oplus
