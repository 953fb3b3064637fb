// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "properties/experiments/process_of_its_own.hpp"
#include "properties/experiments/table.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// Runs both engines on a pair, one after the other, each in a process of its own in which the pair
/// is made: rca for the thesis's RCA, winding for its CWEIN. Both find low-dimensional features, as
/// in the thesis (Section 6.2.1). The times are of the median of five runs where the arrangement
/// has at most 20,000 edges, of three up to 600,000, else of one.
///
/// Columns: m and n, the vertices of the summands; of each engine, after its name, what became of it
/// (`outcome`, "done" where all went well), its arrangement, its questions, its stages and `time`,
/// their sum without the output, in seconds, and `busy`, for how much of that run a processor worked on
/// it: where other programs compete it is less than 1, and the times are too long; `ratio` and `ratio_with_output`, of rca to winding;
/// what the sum is made of, and whether both have the `same_sum`.
Row measured_engines(const std::function<Summands()>& make, std::size_t memory_limit_mb);

/// The columns in their order.
std::vector<std::string> engine_columns();

/// The same from what the processes reported.
Row row_of(const ProcessReport& rca, const ProcessReport& winding);

/// What is wrong in a row, in words; empty if nothing is. To be out of memory is not wrong.
std::string fault_of(const Row& row);

/// Whether both engines were measured.
bool is_complete(const Row& row);

}  // namespace oplus
