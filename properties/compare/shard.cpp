// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/shard.hpp"

#include <charconv>

#include "reference/io/quoting.hpp"

namespace oplus {

std::vector<std::size_t> Shard::cases_of(std::size_t count) const {
  std::vector<std::size_t> result;
  for (std::size_t i = index - 1; i < count; i += of) result.push_back(i);
  return result;
}

std::optional<Shard> shard_of(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec != std::errc() || index.ptr == end || *index.ptr != '/') return std::nullopt;
  const auto of = std::from_chars(index.ptr + 1, end, shard.of);
  if (of.ec != std::errc() || of.ptr != end) return std::nullopt;
  if (shard.index < 1 || shard.index > shard.of) return std::nullopt;
  return shard;
}

std::string no_shard(const std::string& text) {
  return "--shard " + one_line(text) + " names no shard; expected I/N, 1 <= I <= N";
}

}  // namespace oplus
