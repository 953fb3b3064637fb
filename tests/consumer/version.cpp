// SPDX-License-Identifier: MIT
#include <iostream>
#include <oplus/oplus.hpp>
#include <string>

/// The version in the headers is that of the package.
int main() {
  const std::string version = std::to_string(OPLUS_VERSION_MAJOR) + "." +
                              std::to_string(OPLUS_VERSION_MINOR) + "." +
                              std::to_string(OPLUS_VERSION_PATCH);
  std::cout << "headers of oplus " << version << ", package " << FOUND_VERSION << '\n';
  return version == FOUND_VERSION ? 0 : 1;
}
