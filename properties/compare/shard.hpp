// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace oplus {

/// A part of a campaign that is run on several machines: task i, from 0, is of shard i mod `of` + 1,
/// however many threads there are.
struct Shard {
  std::size_t index = 1;  ///< 1 <= index <= of
  std::size_t of = 1;

  /// How many of `all` tasks are of the shard.
  std::size_t count_of(std::size_t all) const { return (all + of - index) / of; }
  /// The number, among all, of the shard's k-th task, from 0.
  std::size_t task(std::size_t k) const { return index - 1 + k * of; }
};

/// Reads "2/8"; none where it names no shard.
std::optional<Shard> shard_of(const std::string& text);

}  // namespace oplus
