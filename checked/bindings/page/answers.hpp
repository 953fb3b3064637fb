// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace oplus {

/// Answers one request of the page, JSON for JSON: docs/web.md. What is wrong with the input is the member
/// "error" of the answer, in a line.
std::string answer(const std::string& request);

}  // namespace oplus

/// The same for JavaScript. The result is valid until the next call.
extern "C" const char* oplus_answer(const char* request);
