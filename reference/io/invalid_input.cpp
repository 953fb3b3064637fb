// SPDX-License-Identifier: MIT
#include "reference/io/invalid_input.hpp"

#include <utility>

#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

std::string message(const Place& where, const std::string& wrong, const std::string& expected) {
  std::string text = one_line(where.file);
  if (where.line != 0) text += ':' + std::to_string(where.line);
  if (where.line != 0 && where.column != 0) text += ':' + std::to_string(where.column);
  return text + ": " + wrong + "; expected " + expected;
}

}  // namespace

InvalidInput::InvalidInput(Place where, const std::string& wrong, const std::string& expected)

    : std::runtime_error(message(where, wrong, expected)),
      where_(std::move(where)),
      wrong_(wrong),
      expected_(expected) {}

}  // namespace oplus
