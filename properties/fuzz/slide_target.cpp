// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/pair_of_bytes.hpp"
#include "properties/fuzz/slide_check.hpp"

namespace oplus {

const FuzzTarget slide_target{"slide", "slide against sums of convex parts, closed and open",
                              [](std::string_view bytes) {
                                const auto pair = pair_of_bytes(bytes);
                                if (!pair) return FuzzOutcome::rejected;
                                check_slide(*pair, laws_for(bytes));
                                return FuzzOutcome::reached;
                              },
                              nullptr, 256};

}  // namespace oplus
