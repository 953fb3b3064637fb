// SPDX-License-Identifier: GPL-3.0-or-later
// oplus-peer NAME P Q: a sum by another library, as its users call it. Its exceptions and crashes are not
// caught: how the program ends is the result.
#include <functional>
#include <iostream>
#include <string>

#include "checked/version.hpp"
#include "properties/compare/peers/peer_table.hpp"
#include "properties/compare/peers/sum_of_chains.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace {

using namespace oplus;

int usage(std::ostream& out, int exit_code) {
  out << "oplus-peer NAME P Q: the closed Minkowski sum of two regions by another library\n"
         "P and Q are files in any format that oplus reads; the sum is written in WKT.\n\n";
  for_each_peer([&](const std::string& name, const char* what, auto /*method*/) {
    out << "  " << name << std::string(22 - name.size(), ' ') << what << '\n';
  });
  out << "\nExit codes:\n"
         "  0   a sum\n"
         "  2   invalid usage or input\n"
      << "  " << exit_no_region << "  what the library returned is not the boundary of a region\n"
      << "  " << exit_refused << "  the library does not support such a pair\n"
      << "Any other: the library crashed.\n";
  return exit_code;
}

int sum(const std::function<MethodFunction>& method, const std::string& p, const std::string& q) {
  Summands pair;
  try {
    pair = {read_region_file(p).region, read_region_file(q).region};
  } catch (const InvalidInput& e) {
    std::cerr << "oplus-peer: " << e.what() << '\n';
    return 2;
  }
  try {
    std::cout << written(sum_of_chains(method(pair)), Format::wkt);
  } catch (const Unsupported& e) {
    std::cerr << e.what() << '\n';
    return exit_refused;
  } catch (const EngineFailure& e) {
    std::cerr << e.site() << '\n' << e.what() << '\n';
    return exit_no_region;
  }
  return std::cout.flush() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && (argv[1] == std::string("--help") || argv[1] == std::string("-h")))
    return usage(std::cout, 0);
  if (argc == 2 && argv[1] == std::string("--version")) {
    std::cout << "oplus-peer " << version << '\n';
    return std::cout.flush() ? 0 : 2;
  }
  std::function<MethodFunction> chosen;
  for_each_peer([&](const std::string& name, const char*, auto method) {
    if (argc == 4 && name == argv[1]) chosen = method;
  });
  return chosen ? sum(chosen, argv[2], argv[3]) : usage(std::cerr, 2);
}
