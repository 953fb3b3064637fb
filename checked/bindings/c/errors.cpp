// SPDX-License-Identifier: MIT
#include "checked/bindings/c/errors.hpp"

#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

#include "checked/oplus/oplus.hpp"

namespace oplus::c {

namespace {

thread_local std::string kept;
thread_local const char* message = "";

oplus_code failed(oplus_code code, const char* what) noexcept {
  try {
    kept = what;
    message = kept.c_str();
    return code;
  } catch (const std::bad_alloc&) {
    message = "out of memory";
    return OPLUS_NO_MEMORY;
  }
}

}  // namespace

oplus_code code_of_exception() noexcept {
  try {
    throw;
  } catch (const InvalidInput& error) {
    return failed(OPLUS_INVALID_INPUT, error.what());
  } catch (const std::invalid_argument& error) {
    return failed(OPLUS_INVALID_INPUT, error.what());
  } catch (const std::bad_alloc&) {
    return failed(OPLUS_NO_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(OPLUS_FAILED, error.what());
  } catch (...) {
    return failed(OPLUS_FAILED, "an unknown exception");
  }
}

void refuse(const char* name, const std::string& wrong, const std::string& expected) {
  throw InvalidInput({name, 0, 0}, wrong, expected);
}

int one_of(int number, int last, const char* name) {
  if (number < 0 || number > last)
    refuse(name, "it is " + std::to_string(number), "0 to " + std::to_string(last));
  return number;
}

char* copied(const std::string& text) {
  auto* copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace oplus::c

const char* oplus_message() { return oplus::c::message; }

void oplus_free_text(char* text) { std::free(text); }
