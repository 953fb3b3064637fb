// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/experiments/experiment.hpp"

namespace oplus {

/// What a page shows of a table whose rows are from measured_engines: sizes, times, ratio and memory;
/// then the stages of each engine. `first` are the columns that tell the rows apart.
std::vector<ShownTable> shown_engine_tables(const std::vector<ShownColumn>& first);

/// What the index says of the ratio of rca to winding, with and without the output: at the first
/// complete row, at the last, and the median. Nothing where no row is complete.
std::vector<std::string> ratio_lines(const Table& table);

/// Appends what is wrong in the row.
void add_faults(const Row& row, const std::string& of_what, std::vector<std::string>& wrong);

/// A line for whoever waits.
std::string progress_line(const std::string& of_what, const Row& row);

}  // namespace oplus
