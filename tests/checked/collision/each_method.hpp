// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "checked/collision/collision_test.hpp"
#include "checked/sweep/sweep_collision.hpp"

namespace oplus {

/// The collision test of two regions by each method, for what all must answer alike.
class EachMethod {
 public:
  EachMethod(const Region& p, const Region& q) {
    tests_.emplace_back("hierarchy", hierarchy_collision(p, q));
    tests_.emplace_back("sweep", sweep_collision(p, q));
    tests_.emplace_back("naive", naive_collision(p, q));
  }

  /// Returns the names of the methods that do not give the answer.
  std::string wrong_at(const Point& x, bool answer) const {
    std::string wrong;
    for (const auto& [name, test] : tests_)
      if (test->interiors_meet_at(x) != answer) wrong += " " + name;
    return wrong;
  }

 private:
  std::vector<std::pair<std::string, std::unique_ptr<CollisionTest>>> tests_;
};

}  // namespace oplus
