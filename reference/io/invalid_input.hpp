// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace oplus {

/// A place in an input, lines and columns from one; column 0 means the whole line.
struct Place {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
};

/// Input that is not what it should be. what() is one line, "file:line:column: what is wrong; what
/// was expected", and names the chain and the edges or vertices where a region is invalid.
class InvalidInput : public std::runtime_error {
 public:
  InvalidInput(Place where, const std::string& wrong, const std::string& expected);
  const Place& where() const { return where_; }

 private:
  Place where_;
};

}  // namespace oplus
