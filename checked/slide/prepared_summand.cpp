// SPDX-License-Identifier: MIT
#include "checked/slide/prepared_summand.hpp"

#include <utility>

#include "checked/slide/kept_summands.hpp"

namespace oplus::slide {

PreparedSummand::PreparedSummand(Region region)
    : PreparedSummand(std::make_shared<const Region>(std::move(region))) {}

PreparedSummand::PreparedSummand(std::shared_ptr<const Region> region)
    : region_(std::move(region)),
      bits_of_integers_(slide::bits_of_integers(*region_)),
      kept_(std::make_unique<KeptSummands>()) {}

PreparedSummand::~PreparedSummand() = default;
PreparedSummand::PreparedSummand(PreparedSummand&&) noexcept = default;
PreparedSummand& PreparedSummand::operator=(PreparedSummand&&) noexcept = default;

}  // namespace oplus::slide
