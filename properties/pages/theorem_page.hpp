// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/pages/registry_with_records.hpp"

namespace oplus {

/// A file below docs/, by its path from there.
struct Page {
  std::string path;
  std::string text;
};

/// docs/theorems/ID.md and its pictures of a typical case and of a shrunk counterexample.
std::vector<Page> theorem_pages(const Registry& registry, const Statement& statement);

}  // namespace oplus
