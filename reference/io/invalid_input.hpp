// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace oplus {

/// A place in an input, lines and columns from one; column 0 means the whole line.
struct Place {
  std::string file;        ///< or what messages call the input
  std::size_t line = 0;    ///< 0: unknown, as for input from code
  std::size_t column = 0;  ///< 0: unknown, or the whole line
};

/// Invalid input. what() is one line, "file:line:column: what is wrong; what
/// was expected", and names the chain and the edges or vertices where a region is invalid.
class InvalidInput : public std::runtime_error {
 public:
  /// Makes the message from what is wrong and what was expected, each without a full stop.
  InvalidInput(Place where, const std::string& wrong, const std::string& expected);
  const Place& where() const { return where_; }  ///< Returns the place in the input.
  const std::string& wrong() const {
    return wrong_;
  }  ///< Returns what is wrong, without the place.
  const std::string& expected() const { return expected_; }  ///< Returns what was expected.

 private:
  Place where_;
  std::string wrong_;
  std::string expected_;
};

}  // namespace oplus
