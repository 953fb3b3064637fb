// SPDX-License-Identifier: GPL-3.0-or-later
// oplus-peer NAME P Q: a sum by somebody else's library, as its users call it. Nothing that it does is
// caught: how it ends is what there is to know.
#include <iostream>
#include <string>
#include <vector>

#include "properties/compare/peers/peer_table.hpp"
#include "properties/compare/peers/sum_of_chains.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace {

using namespace oplus;

/// Those of the table, in this process.
std::vector<Engine> methods() {
  std::vector<Engine> all;
  for_each_peer([&](const char* name, const char* what, Arithmetic arithmetic, auto method) {
    all.push_back({.name = name,
                   .what = what,
                   .arithmetic = arithmetic,
                   .compute = [method](const Region& p, const Region& q, Boundary /*closed*/,
                                       const EngineOptions& /*none*/) {
                     return ComputedSum{sum_of_chains(method(Summands{p, q})), {}, {}};
                   }});
  });
  return all;
}

int usage(std::ostream& out, int exit_code) {
  out << "oplus-peer NAME P Q: the closed Minkowski sum of two regions by somebody else's library\n"
         "P and Q are files in any format that oplus reads; the sum is written in WKT.\n\n";
  for (const Engine& peer : methods())
    out << "  " << peer.name << std::string(22 - peer.name.size(), ' ') << peer.what << '\n';
  out << "\nExit codes: 0 a sum, 2 usage or input, " << exit_no_region
      << " what the library returned bounds no region, " << exit_not_taken
      << " the library does not\ntake such a pair. What the library does is not caught: it may end"
         " otherwise.\n";
  return exit_code;
}

int sum(const Engine& engine, const std::string& p, const std::string& q) {
  Summands pair;
  try {
    pair = {read_region_file(p).region, read_region_file(q).region};
  } catch (const InvalidInput& e) {
    std::cerr << "oplus-peer: " << e.what() << '\n';
    return 2;
  }
  try {
    std::cout << written(engine.compute(pair.p, pair.q, Boundary::closed, {}).sum, Format::wkt);
  } catch (const NotTaken& e) {
    std::cerr << e.what() << '\n';
    return exit_not_taken;
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
  const std::vector<Engine> all = methods();
  const Engine* engine = argc == 4 ? find_engine(all, argv[1]) : nullptr;
  return engine == nullptr ? usage(std::cerr, 2) : sum(*engine, argv[2], argv[3]);
}
