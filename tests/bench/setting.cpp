// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/version.h>

#include <boost/version.hpp>
#include <fstream>
#include <polyclipping/clipper.hpp>
#include <thread>

#include "tests/bench/report.hpp"

namespace oplus {

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string boost_version() {
  return std::to_string(BOOST_VERSION / 100000) + '.' + std::to_string(BOOST_VERSION / 100 % 1000) +
         '.' + std::to_string(BOOST_VERSION % 100);
}

}  // namespace

Setting this_setting(const std::string& command, double limit) {
  return {processor(),
          std::thread::hardware_concurrency(),
          "GCC " __VERSION__ ", " OPLUS_BENCH_FLAGS,
          "CGAL " CGAL_VERSION_STR ", Clipper " CLIPPER_VERSION ", Boost " + boost_version(),
          OPLUS_BENCH_COMMIT,
          command,
          limit,
          {}};
}

}  // namespace oplus
