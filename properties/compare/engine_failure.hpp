// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace oplus {

/// An engine returned no sum. what() says why in a line.
class EngineFailure : public std::runtime_error {
 public:
  enum class Kind {
    crashed,           ///< ended by a signal, an assertion, an exception
    hung,              ///< still running when its time was up
    out_of_memory,     ///< needed more memory than its limit
    unreadable,        ///< what it wrote is not a sum
    open_unsupported,  ///< an open sum, which it has no interface for; no fault
    refused,           ///< it does not support such regions, and says so; no fault
  };

  /// `site` tells kinds of failure apart: a signal, an assertion with its file; no numbers that
  /// change from pair to pair.
  EngineFailure(Kind kind, std::string site, const std::string& what)
      : std::runtime_error(what), kind_(kind), site_(std::move(site)) {}

  Kind kind() const { return kind_; }
  const std::string& site() const { return site_; }

 private:
  Kind kind_;
  std::string site_;
};

inline bool is_fault(EngineFailure::Kind kind) {
  return kind != EngineFailure::Kind::open_unsupported && kind != EngineFailure::Kind::refused;
}

/// "crashed", "hung", …
inline std::string name(EngineFailure::Kind kind) {
  constexpr std::array names = {"crashed",          "hung",   "out of memory", "unreadable",
                                "open unsupported", "refused"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace oplus
