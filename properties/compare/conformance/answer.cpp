// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance/answer.hpp"

#include <algorithm>
#include <cctype>
#include <exception>
#include <system_error>

#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

/// Digits are coordinates or addresses, which change from pair to pair.
std::string without_digits(std::string text) {
  std::string result;
  for (const char c : one_line(text)) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) result += c;
  }
  return result.substr(0, 120);
}

}  // namespace

Answer ask(const Engine& implementation, const Region& p, const Region& q, Boundary boundary) {
  Answer answer;
  try {
    answer.sum = implementation.compute(p, q, boundary, {}).sum;
  } catch (const NoSum& e) {
    answer.no_sum = e.kind();
    answer.site = one_line(e.site());
    answer.what = one_line(e.what());
  } catch (const std::system_error&) {
    throw;  // there is no process to be had, which is no fault of who was asked
  } catch (const std::exception& e) {
    answer.site = "exception: " + without_digits(e.what());
    answer.what = "it threw: " + one_line(e.what());
  } catch (...) {
    answer.site = "exception of an unknown type";
    answer.what = "it threw what is no std::exception";
  }
  return answer;
}

}  // namespace oplus
