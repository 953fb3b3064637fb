// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cstdlib>

#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

class AtFault : public PreparedPairs {
 public:
  void forget() override {}
  void describe(Measurement&) const override {}
};

class Crash : public AtFault {
 public:
  void compute() override { std::abort(); }
};

class Hang : public AtFault {
 public:
  void compute() override {
    while (true) ::pause();
  }
};

}  // namespace

std::unique_ptr<PreparedPairs> prepare_crash(const std::vector<Summands>&) {
  return std::make_unique<Crash>();
}

std::unique_ptr<PreparedPairs> prepare_hang(const std::vector<Summands>&) {
  return std::make_unique<Hang>();
}

}  // namespace oplus
