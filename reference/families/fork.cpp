// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <vector>

#include "reference/families/pairs.hpp"

namespace oplus {

namespace {

/// A tooth of one of the arms: where it begins and ends along its arm. The L has arms of width 1, so
/// a gap of 1 between two closes in the sum and one of 2 or more stays open.
struct Tooth {
  int from;
  int to;
};

/// A square block below and to the left of the origin, an arm along the bottom with teeth up to the
/// x-axis, an arm along the left with teeth to the right, up to the y-axis. The L's horizontal arm
/// draws a bar out of each tooth on the left, its vertical arm one out of each at the bottom; they
/// cross in the first quadrant, and between them, and the block's shadow, are the n² holes. All
/// else is below or left of that: the teeth are as long as the L.
Summands fork_and_l(const std::vector<Tooth>& right, const std::vector<Tooth>& up) {
  const int arm = std::max(right.back().to, up.back().to) + 2;
  Chain fork{{-arm - 1, -arm - 1}};
  for (std::size_t i = right.size(); i-- > 0;) {
    const bool last = i + 1 == right.size();
    fork.push_back({right[i].to, last ? -arm - 1 : -arm});
    fork.push_back({right[i].to, 0});
    fork.push_back({right[i].from, 0});
    fork.push_back({right[i].from, -arm});
  }
  fork.push_back({0, -arm});
  fork.push_back({0, 0});
  fork.push_back({-arm, 0});
  for (std::size_t i = 0; i < up.size(); ++i) {
    const bool last = i + 1 == up.size();
    fork.push_back({-arm, up[i].from});
    fork.push_back({0, up[i].from});
    fork.push_back({0, up[i].to});
    fork.push_back({last ? -arm - 1 : -arm, up[i].to});
  }
  Chain l{{0, 0}, {arm, 0}, {arm, 1}, {1, 1}, {1, arm}, {0, arm}};
  return {polygon(std::move(fork)), polygon(std::move(l))};
}

std::vector<Tooth> random_teeth(Random& random, std::size_t count) {
  std::vector<Tooth> teeth;
  int end = 0;
  while (teeth.size() < count) {
    const int width = uniform(random, 1, 3);
    const int from = end + uniform(random, 2, 4);
    end = from + width;
    teeth.push_back({from, end});
  }
  return teeth;
}

}  // namespace

Summands fork_and_l(std::size_t teeth) {
  std::vector<Tooth> equal;
  for (int i = 0; equal.size() < teeth; ++i) equal.push_back({3 * i + 2, 3 * i + 3});
  return fork_and_l(equal, equal);
}

Summands fork_pair(Random& random, std::size_t n) {
  if (one_in(random, 4)) return fork_and_l(n);
  const std::vector<Tooth> right = random_teeth(random, n);
  const std::vector<Tooth> up = random_teeth(random, n);
  return fork_and_l(right, up);
}

}  // namespace oplus
