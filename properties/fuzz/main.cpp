// SPDX-License-Identifier: GPL-3.0-or-later
// Connects one target to libFuzzer: OPLUS_FUZZ_TARGET is its name in fuzz_target.hpp.
#include <gmp.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <utility>

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

/// GMP allocates for each number, and the sanitizers' allocator would take a third of the time: freed blocks
/// are used again. GMP is not instrumented, so that they see no access to these in any case.
class GmpMemory {
 public:
  static void* allocate(std::size_t bytes) {
    if (bytes > most) return std::malloc(bytes);
    const Lock lock;
    Block*& first = free_blocks[place(bytes)];
    if (first == nullptr) return std::malloc(place(bytes) * unit);
    return std::exchange(first, first->next);
  }
  static void* reallocate(void* old, std::size_t old_bytes, std::size_t bytes) {
    void* const block = allocate(bytes);
    std::memcpy(block, old, std::min(old_bytes, bytes));
    free(old, old_bytes);
    return block;
  }
  static void free(void* old, std::size_t bytes) {
    if (bytes > most) return std::free(old);
    const Lock lock;
    Block*& first = free_blocks[place(bytes)];
    first = new (old) Block{first};
  }

 private:
  struct Block {
    Block* next;
  };
  /// Threads hardly ever meet here, and a mutex would take longer than all the rest.
  struct Lock {
    Lock() {
      while (is_locked.test_and_set(std::memory_order_acquire)) {
      }
    }
    ~Lock() { is_locked.clear(std::memory_order_release); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
  };
  static constexpr std::size_t unit = 16, most = 256;
  static std::size_t place(std::size_t bytes) {
    return std::max<std::size_t>((bytes + unit - 1) / unit, 1);
  }
  static inline std::atomic_flag is_locked;
  static inline std::array<Block*, most / unit + 1> free_blocks{};
};

}  // namespace

/// GMP has no frame pointers, so that each allocation would have a stack of its own to be stored.
/// ASAN_OPTIONS=malloc_context_size=30 shows more about a finding.
extern "C" const char* __asan_default_options() {
  return "malloc_context_size=1:quarantine_size_mb=16";
}

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  mp_set_memory_functions(GmpMemory::allocate, GmpMemory::reallocate, GmpMemory::free);
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
  if (target.mutated == nullptr || oplus::one_in(random, 2))
    return LLVMFuzzerMutate(data, size, most);
  return put(target.mutated(random, text(data, size)), data, most);
}
