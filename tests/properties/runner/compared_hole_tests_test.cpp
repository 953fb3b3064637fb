// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/compared_hole_tests.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

class Says : public HoleTest {
 public:
  Says(bool about_faces, bool about_points)
      : about_faces_(about_faces), about_points_(about_points) {}
  bool is_hole_right_of(const Segment& /*edge*/) override { return about_faces_; }
  bool interiors_meet_at(const Point& /*x*/) override { return about_points_; }

 private:
  bool about_faces_;
  bool about_points_;
};

/// Three that say yes about faces and no about points, and a fourth.
std::vector<std::unique_ptr<HoleTest>> four(bool about_faces, bool about_points) {
  std::vector<std::unique_ptr<HoleTest>> tests;
  for (int i = 0; i < 3; ++i) tests.push_back(std::make_unique<Says>(true, false));
  tests.push_back(std::make_unique<Says>(about_faces, about_points));
  return tests;
}

TEST(ComparedHoleTests, agree) {
  ComparedHoleTests same(four(true, false));
  EXPECT_TRUE(same.is_hole_right_of({{0, 0}, {1, 0}}));
  EXPECT_FALSE(same.interiors_meet_at({0, 0}));
  EXPECT_FALSE(same.interiors_meet_at({1, 0}));
}

TEST(ComparedHoleTests, say_which_differ_and_where) {
  ComparedHoleTests on_faces(four(false, false));
  EXPECT_FALSE(on_faces.interiors_meet_at({0, 0}));
  try {
    on_faces.is_hole_right_of({{0, 0}, {1, 0}});
    FAIL() << "it did not throw";
  } catch (const HoleTestsDiffer& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("(0, 0) to (1, 0)"), std::string::npos) << what;
    EXPECT_NE(what.find("bvh says yes, ray the opposite"), std::string::npos) << what;
  }
  ComparedHoleTests on_points(four(true, true));
  EXPECT_THROW(on_points.interiors_meet_at({0, 0}), HoleTestsDiffer);
}

TEST(ComparedHoleTests, are_all_hole_tests) {
  const Region frame{{{box(0, 0, 9, 9), {backwards(box(1, 1, 8, 8))}}}};
  const Region square = polygon(box(0, 0, 1, 1));
  ComparedHoleTests all(frame, square);
  EXPECT_TRUE(all.is_hole_right_of({{2, 2}, {2, 8}}));
  EXPECT_FALSE(all.interiors_meet_at({5, 5}));
  EXPECT_TRUE(all.interiors_meet_at({Rational(1, 2), 5}));
}

}  // namespace
}  // namespace oplus
