// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "checked/layouts/builder.hpp"

namespace oplus::layouts {

/// The map that an attribute `transform` stands for: translate, scale, rotate and matrix, the last one first.
/// Throws InvalidInput, with a place in the text.
AffineMap svg_transform(Builder& builder, std::string_view text);

}  // namespace oplus::layouts
