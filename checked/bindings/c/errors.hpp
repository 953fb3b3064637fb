// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "checked/bindings/c/oplus.h"

namespace oplus::c {

/// Returns the code of the exception that is being handled, and keeps its message for oplus_message.
oplus_code code_of_exception() noexcept;

/// Returns the code of a call, which may throw anything.
template <typename Call>
oplus_code code_of(const Call& call) noexcept {
  try {
    call();
    return OPLUS_OK;
  } catch (...) {
    return code_of_exception();
  }
}

/// Throws InvalidInput about what has that name in the header.
[[noreturn]] void refuse(const char* name, const std::string& wrong, const std::string& expected);

/// Returns what a pointer points to. Throws InvalidInput for NULL.
template <typename Value>
Value& given(Value* pointer, const char* name) {
  if (pointer == nullptr) refuse(name, "it is NULL", "a pointer");
  return *pointer;
}

/// Returns a number if it is one of those from 0 to `last`. Throws InvalidInput.
int one_of(int number, int last, const char* name);

/// Returns a copy for oplus_free_text.
char* copied(const std::string& text);

}  // namespace oplus::c
