// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>

#include "reference/definitions/region.hpp"

namespace oplus::slide {

class KeptSummands;

/// A summand of many pairs: what depends on it alone is computed for the first of them and kept. May be
/// used by several threads at a time. Requires: the region is valid (validity.hpp).
class PreparedSummand {
 public:
  explicit PreparedSummand(std::shared_ptr<const Region> region);
  explicit PreparedSummand(Region region);
  ~PreparedSummand();
  PreparedSummand(PreparedSummand&&) noexcept;
  PreparedSummand& operator=(PreparedSummand&&) noexcept;

  const Region& region() const { return *region_; }
  KeptSummands& kept() const { return *kept_; }

  /// The bits of the largest coordinate if all are integers, else 0.
  std::size_t bits_of_integers() const { return bits_of_integers_; }

 private:
  std::shared_ptr<const Region> region_;
  std::size_t bits_of_integers_;
  std::unique_ptr<KeptSummands> kept_;
};

}  // namespace oplus::slide
