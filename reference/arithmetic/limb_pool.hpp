// SPDX-License-Identifier: MIT
#pragma once

namespace oplus {

/// From now on, GMP's numbers of at most 4 limbs take their limbs from lists of free blocks of 1, 2, 3
/// and 4 limbs, for all threads: half the memory of a coordinate, since malloc takes 32 bytes for a limb.
/// Memory in these lists is never returned to the system. Larger numbers are allocated as before.
/// For programs, in which nothing else decides how GMP allocates; before they start threads.
void pool_limbs();

}  // namespace oplus
