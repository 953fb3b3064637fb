// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "tests/bench/report.hpp"

namespace oplus {

/// The table that is written while a run goes on: a head for each row, and a line for each engine.
void write_head(std::ostream& out, const BenchRow& row);
void write_line(std::ostream& out, const Measurement& measurement);

/// How the exact results compare, and how far the rounded ones are off.
void write_agreement(std::ostream& out, const RowReport& row);

/// What became of an engine in a few words: "done", "> 60 s", "crashed: signal 6".
std::string in_words(const Measurement& measurement);

}  // namespace oplus
