// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <kainjow/mustache.hpp>
#include <string>

#include "tests/bench/table.hpp"

namespace oplus {

/// What a template's names stand for.
using PageData = kainjow::mustache::data;

/// A table as the template markdown_table.mustache takes it.
PageData page_data(const Table& table);

/// A section that is replaced by a table of these rows: a line for each of its columns, or several
/// (columns_of), where one with * is there for each of the names, which * stands for.
PageData table_section(const Rows& rows, const std::vector<std::string>& names = {});

/// A list of texts.
PageData page_data(const std::vector<std::string>& texts);

/// A text of Mustache (https://mustache.github.io), with nothing escaped; {{>name}} is
/// name.mustache. Throws std::invalid_argument where it is invalid or has a name that `data` has not.
std::string rendered_text(const std::string& text, const PageData& data);

/// The same for the template of this name in the folder pages/.
std::string rendered(const std::string& name, const PageData& data);

}  // namespace oplus
