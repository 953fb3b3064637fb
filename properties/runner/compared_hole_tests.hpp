// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

#include "checked/arrangement/hole_test.hpp"

namespace oplus {

/// How often hole tests were asked.
struct Probes {
  std::size_t faces = 0;
  std::size_t points = 0;

  Probes& operator+=(const Probes& more) {
    faces += more.faces;
    points += more.points;
    return *this;
  }
};

class HoleTestsDiffer : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// All hole tests as one: every question goes to each of them. An engine that never sees them differ
/// runs the same with any of them. About points, the method of rays asks the hierarchies, so there
/// three are compared.
class ComparedHoleTests : public HoleTest {
 public:
  ComparedHoleTests(const Region& p, const Region& q, Probes& probes);

  /// The given ones, in the order of hole_test_methods().
  ComparedHoleTests(std::vector<std::unique_ptr<HoleTest>> tests, Probes& probes);

  /// Throw HoleTestsDiffer, which says where and who says what.
  bool is_hole_right_of(const Segment& edge) override;
  bool interiors_meet_at(const Point& x) override;

 private:
  std::vector<std::unique_ptr<HoleTest>> tests_;  ///< in the order of hole_test_methods()
  Probes& probes_;
};

}  // namespace oplus
