// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace oplus {

/// A part of a campaign that is run on several machines: case i, from 0, is of shard i mod `of` + 1,
/// however many threads there are.
struct Shard {
  std::size_t index = 1;  ///< 1 <= index <= of
  std::size_t of = 1;

  /// Which of `count` cases are of the shard, in their order.
  std::vector<std::size_t> cases_of(std::size_t count) const;

  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Reads "2/8"; none where it names no shard.
std::optional<Shard> shard_of(const std::string& text);

/// What a command says that was given no shard: a line without its program's name.
std::string no_shard(const std::string& text);

}  // namespace oplus
