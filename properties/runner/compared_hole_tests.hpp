// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>
#include <vector>

#include "checked/arrangement/hole_test.hpp"

namespace oplus {

class HoleTestsDiffer : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// All hole tests as one: each is asked every question. An engine that never sees them differ
/// runs the same with any of them. About points, the method of rays asks the hierarchies, so there
/// three are compared.
class ComparedHoleTests : public HoleTest {
 public:
  ComparedHoleTests(const Region& p, const Region& q);

  /// The given ones, in the order of hole_test_methods().
  explicit ComparedHoleTests(std::vector<std::unique_ptr<HoleTest>> tests);

  /// Throw HoleTestsDiffer, which says where and each test's answer.
  bool is_hole_right_of(const Segment& edge) override;
  bool interiors_meet_at(const Point& x) override;

 private:
  std::vector<std::unique_ptr<HoleTest>> tests_;  ///< in the order of hole_test_methods()
};

}  // namespace oplus
