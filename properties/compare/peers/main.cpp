// SPDX-License-Identifier: GPL-3.0-or-later
// oplus-peer NAME P Q: a sum by another library, as its users call it, or all no-fit polygons of a file of
// parts. Its exceptions and crashes are not caught: how the program ends is the result.
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <system_error>

#include "checked/version.hpp"
#include "properties/compare/peers/peer_table.hpp"
#include "properties/compare/peers/sum_of_chains.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/region_lines.hpp"
#include "reference/io/writing.hpp"

namespace {

using namespace oplus;

int usage(std::ostream& out, int exit_code) {
  out << "oplus-peer NAME P Q: the closed Minkowski sum of two regions by another library\n"
         "P and Q are files in any format that oplus reads; the sum is written in WKT.\n"
         "oplus-peer NAME --parts FILE OUT: all no-fit polygons, the sums of P and -Q, of the parts\n"
         "in FILE, one a line, each with itself too. OUT gets the number by which coordinates are\n"
         "multiplied, and a line of SVG path data for each pair: the chains as the library returns them.\n"
         "oplus-peer --libraries: their versions, and the compiler's.\n\n";
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

void write_sum(const Peer& peer, const std::string& p, const std::string& q) {
  const Summands pair = {read_region_file(p).region, read_region_file(q).region};
  std::cout << written(sum_of_chains(peer.sum(pair)), Format::wkt) << std::flush;
}

void write_no_fit_polygons(const Peer& peer, const std::string& file, const std::string& to) {
  std::ostringstream lines;
  peer.no_fit_polygons(read_region_lines(file), lines);
  try {
    write_file(to, lines.str());
  } catch (const std::system_error& e) {
    throw InvalidInput({to}, e.code().message(), "a file that can be written");
  }
}

int answer(const Peer& peer, const std::vector<std::string>& files) {
  try {
    if (files[0] == "--parts")
      write_no_fit_polygons(peer, files[1], files[2]);
    else
      write_sum(peer, files[0], files[1]);
  } catch (const InvalidInput& e) {
    std::cerr << "oplus-peer: " << e.what() << '\n';
    return 2;
  } catch (const Unsupported& e) {
    std::cerr << e.what() << '\n';
    return exit_refused;
  } catch (const EngineFailure& e) {
    std::cerr << e.site() << '\n' << e.what() << '\n';
    return exit_no_region;
  }
  return std::cout ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && (argv[1] == std::string("--help") || argv[1] == std::string("-h")))
    return usage(std::cout, 0);
  if (argc == 2 && argv[1] == std::string("--version")) {
    std::cout << "oplus-peer " << version << '\n';
    return std::cout.flush() ? 0 : 2;
  }
  if (argc == 2 && argv[1] == std::string("--libraries")) {
    std::cout << libraries_of_peers() << '\n';
    return std::cout.flush() ? 0 : 2;
  }
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::size_t files = words.size() == 4 && words[1] == "--parts" ? 3 : 2;
  std::function<Peer()> chosen;
  for_each_peer([&](const std::string& name, const char*, auto make) {
    if (words.size() == files + 1 && words[0] == name) chosen = make;
  });
  return chosen ? answer(chosen(), {words.begin() + 1, words.end()}) : usage(std::cerr, 2);
}
