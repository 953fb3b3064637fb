// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/pair_mutation.hpp"
#include "properties/fuzz/realized_pair.hpp"
#include "properties/fuzz/slide_check.hpp"

namespace oplus {

const FuzzTarget slide_target{"slide",
                              "slide against winding numbers, closed and open",
                              [](std::string_view bytes) {
                                const auto pair = realized(decoded(bytes));
                                if (!pair) return FuzzOutcome::rejected;
                                check_slide(pair->summands, laws_for(bytes));
                                return FuzzOutcome::reached;
                              },
                              mutated_pair,
                              crossed_pair,
                              4,
                              256};

}  // namespace oplus
