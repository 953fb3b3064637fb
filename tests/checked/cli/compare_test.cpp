// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Compare : public ShellWithRegions {
 protected:
  Compare() {
    put("slit.wkt",
        "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)), LINESTRING (1 2, 3 2))");
    put("dot.wkt", "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)), POINT (1 2))");
  }

  void expect_difference(const std::string& files, const std::string& first_lines) const {
    const Ran ran = run("oplus compare " + files, 1);
    EXPECT_EQ(ran.out.substr(0, first_lines.size()), first_lines) << files;
    EXPECT_EQ(ran.err, "");
  }
};

TEST_F(Compare, equal_in_any_format_and_from_any_first_vertex) {
  put("other.dat", "5\n4 4\n0 4\n0 0\n2 0\n4 0\n");
  for (const std::string files :
       {"full.wkt other.dat", "full.wkt - <other.dat", "- full.wkt <full.wkt", "slit.wkt slit.wkt"})
    expect_output("oplus compare " + files, "equal\n");
}

TEST_F(Compare, a_hole_is_found) {
  expect_difference("frame.wkt full.wkt",
                    "not equal: a hole of the first is filled, wholly or in part, in the second\n"
                    "witness: (2, 2) is outside the first and inside the second\n"
                    "first: outer chains 1, holes 1, dangling edges 0, isolated vertices 0, area "
                    "12\nsecond: outer chains 1, holes 0, ");
  expect_difference("full.wkt frame.wkt",
                    "not equal: a hole of the second is filled, wholly or in part, in the first\n"
                    "witness: (2, 2) is inside the first and outside the second\n");
}

TEST_F(Compare, low_dimensional_features_are_found) {
  expect_difference("slit.wkt full.wkt",
                    "not equal: a dangling edge of the first is not one of the second\n"
                    "witness: (2, 2) is on the boundary of the first and inside the second\n");
  expect_difference("slit.wkt dot.wkt", "not equal: a dangling edge of the first");
  expect_difference("full.wkt dot.wkt",
                    "not equal: an isolated vertex of the second is not one of the first\n"
                    "witness: (1, 2) is inside the first and on the boundary of the second\n");
}

TEST_F(Compare, the_empty_sum) {
  expect_output("oplus compare empty.wkt empty.wkt", "equal\n");
  expect_difference("empty.wkt full.wkt",
                    "not equal: the second covers a place outside the first\n");
}

TEST_F(Compare, refuses_what_it_cannot_read) {
  expect_refusal("oplus compare full.wkt", "B");
  expect_refusal("oplus compare full.wkt missing.wkt", "missing.wkt");
  expect_refusal("oplus compare - - <full.wkt", "standard input");
  expect_refusal("oplus compare full.wkt frame.wkt >/dev/full", "standard output");
}

}  // namespace
}  // namespace oplus
