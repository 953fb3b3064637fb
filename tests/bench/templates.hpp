// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <kainjow/mustache.hpp>
#include <string>

#include "tests/bench/table.hpp"

namespace oplus {

/// The values of a template's names.
using PageData = kainjow::mustache::data;

/// A table for the template markdown_table.mustache.
PageData page_data(const Table& table);

/// A section that is replaced by a table of these rows. Its lines are columns (columns_of); a line with *
/// is repeated for each of the names, which replaces *.
PageData table_section(const Rows& rows, const std::vector<std::string>& names = {});

/// A list of texts.
PageData page_data(const std::vector<std::string>& texts);

/// Renders a Mustache template (https://mustache.github.io) without escaping; {{>name}} includes
/// name.mustache. Throws std::invalid_argument if it is invalid or has a name that `data` lacks.
std::string rendered_text(const std::string& text, const PageData& data);

/// Renders the template of this name in the folder pages/.
std::string rendered(const std::string& name, const PageData& data);

}  // namespace oplus
