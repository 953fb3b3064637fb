// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/arithmetic/limb_pool.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>
#include <vector>

namespace oplus {
namespace {

std::size_t bytes_in_use = 0;  // of malloc, by GMP and the pool

/// Has GMP pool limbs as long as it lives; no number that changed meanwhile may live longer.
class LimbPool : public testing::Test {
 protected:
  LimbPool() {
    mp_get_memory_functions(&allocate_, &reallocate_, &free_);
    bytes_in_use = 0;
    mp_set_memory_functions(
        [](std::size_t bytes) {
          bytes_in_use += bytes;
          return std::malloc(bytes);
        },
        [](void* memory, std::size_t bytes, std::size_t wanted) {
          bytes_in_use += wanted - bytes;
          return std::realloc(memory, wanted);
        },
        [](void* memory, std::size_t bytes) {
          bytes_in_use -= bytes;
          std::free(memory);
        });
    pool_limbs();
  }
  ~LimbPool() override { mp_set_memory_functions(allocate_, reallocate_, free_); }

 private:
  void* (*allocate_)(std::size_t);
  void* (*reallocate_)(void*, std::size_t, std::size_t);
  void (*free_)(void*, std::size_t);
};

std::vector<mpz_class> powers_of_three(std::size_t count) {
  std::vector<mpz_class> powers;
  for (std::size_t i = 0; i < count; ++i)
    powers.push_back(i == 0 ? 1 : mpz_class(3 * powers[i - 1]));
  return powers;
}

TEST_F(LimbPool, keeps_numbers_that_grow_and_shrink) {
  const std::vector<mpz_class> powers = powers_of_three(400);  // of up to 10 limbs
  mpz_class power = powers.back();
  for (std::size_t i = powers.size(); i-- > 0; power /= 3) {
    EXPECT_EQ(power, powers[i]) << i;
    mpz_realloc2(power.get_mpz_t(), mpz_sizeinbase(power.get_mpz_t(), 2));
  }
  EXPECT_EQ(power, 0);
  EXPECT_EQ(powers[100].get_str(), "515377520732011331036461129765621272702107522001");
}

TEST_F(LimbPool, takes_eight_bytes_for_a_limb) {
  constexpr std::size_t count = 100'000;
  std::vector<mpz_class> numbers(count);
  const std::size_t before = bytes_in_use;
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<unsigned long>(i);
  EXPECT_LT(bytes_in_use - before, 9 * count);
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(numbers[i], static_cast<unsigned long>(i));
}

TEST_F(LimbPool, gives_what_one_thread_frees_to_others) {
  constexpr std::size_t count = 50'000;
  std::vector<mpz_class> numbers;
  std::size_t after_the_first = 0;
  for (int round = 0; round < 20; ++round) {
    numbers.clear();
    numbers.resize(count);
    std::thread([&] {
      for (mpz_class& number : numbers) number = 5;
    }).join();
    if (round == 1) after_the_first = bytes_in_use;
  }
  EXPECT_LE(bytes_in_use, after_the_first);
  for (const mpz_class& number : numbers) EXPECT_EQ(number, 5);
}

}  // namespace
}  // namespace oplus
