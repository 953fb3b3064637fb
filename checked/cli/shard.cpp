// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/shard.hpp"

#include <charconv>

#include "checked/cli/usage_error.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

Shard shard_of(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec == std::errc() && index.ptr != end && *index.ptr == '/') {
    const auto of = std::from_chars(index.ptr + 1, end, shard.of);
    if (of.ec == std::errc() && of.ptr == end && 1 <= shard.index && shard.index <= shard.of)
      return shard;
  }
  throw UsageError("--shard " + one_line(text) + " is invalid; expected I/N, 1 <= I <= N");
}

}  // namespace oplus
