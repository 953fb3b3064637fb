// SPDX-License-Identifier: GPL-3.0-or-later
// Connects one target to libFuzzer: OPLUS_FUZZ_TARGET is its name in fuzz_target.hpp.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>

#include "properties/fuzz/fuzz_target.hpp"
#include "reference/definitions/mutant.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

constexpr const oplus::FuzzTarget& target = oplus::OPLUS_FUZZ_TARGET;

struct Counts {
  std::size_t reached = 0;
  std::size_t rejected = 0;
};
Counts counts;

std::string_view text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

std::size_t put(const std::string& input, std::uint8_t* data, std::size_t most) {
  const std::size_t size = std::min(input.size(), most);
  std::memcpy(data, input.data(), size);
  return size;
}

}  // namespace

/// GMP has no frame pointers, so that each allocation would have a stack of its own to be stored.
/// ASAN_OPTIONS=malloc_context_size=30 shows more about a finding.
extern "C" const char* __asan_default_options() {
  return "malloc_context_size=1:quarantine_size_mb=16";
}

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
#ifdef OPLUS_MUTANTS
  // To check by hand that a target finds a fault.
  if (const char* mutant = std::getenv("OPLUS_MUTANT")) oplus::active_mutant = mutant;
#endif
  std::atexit([] {
    std::cerr << "oplus: reached " << counts.reached << ", rejected " << counts.rejected << '\n';
  });
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const bool reached = target.run(text(data, size)) == oplus::FuzzOutcome::reached;
    ++(reached ? counts.reached : counts.rejected);
  } catch (const std::exception& e) {
    std::cerr << "oplus: finding: " << e.what() << std::endl;
    std::abort();
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  oplus::Random random(seed);
  // Bytes, too: invalid structures, and what comparisons and dictionaries suggest.
  if (oplus::one_in(random, target.bytes_one_in)) return LLVMFuzzerMutate(data, size, most);
  return put(target.mutated(random, text(data, size)), data, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t size_of_a,
                                                 const std::uint8_t* b, std::size_t size_of_b,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  // libFuzzer then crosses over in LLVMFuzzerMutate only.
  if (target.crossed == nullptr) return 0;
  oplus::Random random(seed);
  return put(target.crossed(random, text(a, size_of_a), text(b, size_of_b)), out, most);
}
