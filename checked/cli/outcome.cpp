// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/outcome.hpp"

#include <exception>
#include <new>
#include <string>

#include "checked/cli/message.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

int fail(ExitCode code, const std::string& why) {
  say_error(why);
  return static_cast<int>(code);
}

int fail_with_bug(const std::string& what) {
  return fail(ExitCode::bug, "a bug in oplus: " + what + "; please report it with the input");
}

}  // namespace

int exit_code_of(const Action& action) noexcept {
  try {
    return static_cast<int>(action());
  } catch (const InvalidInput& error) {
    return fail(ExitCode::invalid, error.what());
  } catch (const UsageError& error) {
    return fail(ExitCode::invalid, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::invalid, "there is not enough memory for this input");
  } catch (const std::exception& error) {
    return fail_with_bug(error.what());
  } catch (...) {
    return fail_with_bug("an unknown exception");
  }
}

}  // namespace oplus
