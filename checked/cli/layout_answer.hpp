// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "checked/layouts/check.hpp"
#include "checked/layouts/layout.hpp"

namespace oplus {

/// What `oplus layout` says of a layout: docs/layouts.md. `verdicts` are those of its sheets.
using Verdicts = std::vector<SheetVerdict>;

bool is_right(const Verdicts& verdicts);

std::string text_answer(const Layout& layout, const Verdicts& verdicts);
std::string json_answer(const Layout& layout, const Verdicts& verdicts);
/// A picture; what is wrong is red.
std::string svg_answer(const Layout& layout, const Verdicts& verdicts);
/// The parts where they lie, in WKT, one a line.
std::string wkt_answer(const Layout& layout, const Verdicts& verdicts);
/// The containers, in WKT, one a line; EMPTY is none.
std::string container_answer(const Layout& layout, const Verdicts& verdicts);

}  // namespace oplus
