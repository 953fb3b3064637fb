// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace oplus {

/// A part of tasks that are done on several machines: task i, from 0, is of shard i mod `of` + 1, however many
/// threads there are.
struct Shard {
  std::size_t index = 1;  ///< 1 <= index <= of
  std::size_t of = 1;

  /// How many of `all` tasks are of the shard.
  std::size_t count_of(std::size_t all) const { return (all + of - index) / of; }
  /// The number, among all, of the shard's k-th task, from 0.
  std::size_t task(std::size_t k) const { return index - 1 + k * of; }
  /// Whether task i is of the shard: then it is its task i / of.
  bool has(std::size_t i) const { return i % of == index - 1; }

  bool operator==(const Shard&) const = default;
};

/// The value of --shard, such as 2/8. Throws UsageError.
Shard shard_of(const std::string& text);

}  // namespace oplus
