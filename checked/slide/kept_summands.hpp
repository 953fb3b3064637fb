// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "checked/slide/kept_summand.hpp"
#include "checked/slide/number_types.hpp"
#include "checked/slide/scaling.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// One summand, kept in the scalings of the first pairs that it belongs to. Coordinates depend on the
/// denominator and on whether they are moved; their doubles also on the shift, and on whether numbers are
/// short. That is less than what a pair's scaling says: the offset is always the middle of the same box.
class KeptSummands {
 public:
  /// Of the summand, which is always the same.
  const Extent& extent(const Region& region) {
    std::call_once(has_extent_, [&] { extent_ = extent_of(region); });
    return extent_;
  }

  template <typename Numbers>
  std::shared_ptr<const KeptSummand<Numbers>> in(const Region& region, const Scaling& scaling,
                                                 const Scaling::Offset& offset) {
    auto& all = std::get<Scaled<Numbers>>(all_);
    const auto is_it = [&](const auto& one) {
      return one.shift == scaling.shift && one.is_short == has_short_numbers(scaling) &&
             one.is_moved == scaling.is_moved &&
             (one.denominator == scaling.denominator ||
              OPLUS_MUTANT("slide-keeps-any-denominator",
                           "a prepared summand is used again with another common denominator"));
    };
    const auto find = [&] {
      const auto found = std::find_if(all.begin(), all.end(), is_it);
      return found == all.end() ? nullptr : found->kept;
    };
    {
      const std::lock_guard lock(mutex_);
      if (auto kept = find()) return kept;
    }
    auto made = std::make_shared<const KeptSummand<Numbers>>(region, scaling, offset);
    const std::lock_guard lock(mutex_);
    // Another thread may have been faster.
    if (auto kept = find()) return kept;
    if (all.size() < most_scalings)
      all.push_back(
          {scaling.denominator, scaling.shift, has_short_numbers(scaling), scaling.is_moved, made});
    return made;
  }

 private:
  static constexpr std::size_t most_scalings = 8;

  template <typename Numbers>
  struct One {
    mpz_class denominator;
    std::size_t shift;
    bool is_short;
    bool is_moved;
    std::shared_ptr<const KeptSummand<Numbers>> kept;
  };
  template <typename Numbers>
  using Scaled = std::vector<One<Numbers>>;

  std::once_flag has_extent_;
  Extent extent_;
  std::mutex mutex_;
  std::tuple<Scaled<SmallNumbers>, Scaled<WideNumbers>, Scaled<AnyNumbers>, Scaled<RationalNumbers>>
      all_;
};

}  // namespace oplus::slide
