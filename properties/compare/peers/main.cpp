// SPDX-License-Identifier: GPL-3.0-or-later
// oplus-peer NAME P Q: a sum by somebody else's library, as its users call it. Nothing that it does is
// caught: how it ends is what there is to know.
#include <iostream>
#include <map>
#include <string>

#include "properties/compare/peers/peer_table.hpp"
#include "properties/compare/peers/returned_chains.hpp"
#include "properties/compare/peers/sum_of_chains.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace {

using namespace oplus;

const std::map<std::string, MethodFunction*> functions{
    {"cgal-reduced", cgal_reduced},
    {"cgal-full", cgal_full},
    {"cgal-vertical", cgal_vertical},
    {"cgal-triangulation", cgal_triangulation},
    {"cgal-small-side", cgal_small_side},
    {"cgal-optimal", cgal_optimal},
    {"cgal-hertel-mehlhorn", cgal_hertel_mehlhorn},
    {"cgal-greene", cgal_greene},
    {"clipper", clipper},
    {"boost-polygon", boost_polygon},
};

int usage(std::ostream& out, int exit_code) {
  out << "oplus-peer NAME P Q: the closed Minkowski sum of two regions by somebody else's library\n"
         "P and Q are files in any format that oplus reads; the sum is written in WKT.\n\n";
  for (const Peer& peer : peers())
    out << "  " << peer.name << std::string(22 - peer.name.size(), ' ') << peer.what << '\n';
  out << "\nExit codes: 0 a sum, 2 usage or input, " << exit_no_region
      << " what the library returned bounds no region, " << exit_not_taken
      << " the library does not\ntake such a pair. What the library does is not caught: it may end"
         " otherwise.\n";
  return exit_code;
}

int sum(MethodFunction* method, const std::string& p, const std::string& q) {
  Summands pair;
  try {
    pair = {read_region_file(p).region, read_region_file(q).region};
  } catch (const InvalidInput& e) {
    std::cerr << "oplus-peer: " << e.what() << '\n';
    return 2;
  }
  ReturnedChains chains;
  try {
    chains = method(pair);
  } catch (const NotTaken& e) {
    std::cerr << e.what() << '\n';
    return exit_not_taken;
  }
  try {
    write(std::cout, sum_of_chains(chains), Format::wkt);
  } catch (const NoRegion& e) {
    std::cerr << e.defect() << '\n' << e.what() << '\n';
    return exit_no_region;
  }
  return std::cout.flush() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && (argv[1] == std::string("--help") || argv[1] == std::string("-h")))
    return usage(std::cout, 0);
  const auto method = argc == 4 ? functions.find(argv[1]) : functions.end();
  return method == functions.end() ? usage(std::cerr, 2) : sum(method->second, argv[2], argv[3]);
}
