// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(Dat, is_one_component_without_a_hole_count) {
  EXPECT_EQ(region_from("3 0 0 1/2 0 0 0.5\n").region,
            polygon({{0, 0}, {Rational(1, 2), 0}, {0, Rational(1, 2)}}));
}

TEST(Dat, may_have_a_hole_count_and_holes) {
  const Region expected{{{rectangle(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  const ReadRegion read = region_from("4\n0 0 3 0 3 3 0 3\n1\n4\n1 1 1 2 2 2 2 1\n");
  EXPECT_EQ(read.region, expected);
  EXPECT_TRUE(read.notes.empty());
  EXPECT_EQ(region_from("4 0 0 1 0 1 1 0 1 0").region, polygon(rectangle(0, 0, 1, 1)));
}

TEST(Dat, may_have_several_components) {
  const Region expected{{{rectangle(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}},
                         {rectangle(5, 0, 6, 1), {}},
                         {rectangle(7, 0, 8, 1), {}}}};
  EXPECT_EQ(region_from("4 0 0 3 0 3 3 0 3 1 4 1 1 1 2 2 2 2 1\r\n"
                        "4 5 0 6 0 6 1 5 1 0\r\n"
                        "4 7 0 8 0 8 1 7 1 0\r\n")
                .region,
            expected);
}

TEST(Dat, zero_is_the_empty_region) {
  EXPECT_EQ(region_from("0\n").region, Region{});
  EXPECT_EQ(region_from(" 000 ").region, Region{});
}

class RefusedDat : public testing::TestWithParam<Refused> {};

TEST_P(RefusedDat, says_why) {
  EXPECT_EQ(refusal([&] { region_from(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, RefusedDat,
    testing::Values(
        Refused{"vertex_count_is_not_an_integer", "3.5 0 0 1 0 0 1",
                "file:1:1: '3.5' where the number of vertices of outer chain of component 1 should "
                "be; expected an integer without a sign"},
        Refused{"vertex_count_is_negative", "\n\n  -3 0 0 1 0 0 1",
                "file:3:3: '-3' where the number of vertices of outer chain of component 1 should "
                "be; expected an integer without a sign"},
        Refused{"vertex_count_is_a_fraction", "6/2 0 0 1 0 0 1",
                "file:1:1: '6/2' where the number of vertices of outer chain of component 1 should "
                "be; expected an integer without a sign"},
        Refused{"vertex_count_too_small", "2\n0 0\n1 1\n",
                "file:1:1: outer chain of component 1 has 2 vertices; expected at least 3"},
        Refused{"one_vertex", "1\n0 0\n",
                "file:1:1: outer chain of component 1 has 1 vertex; expected at least 3"},
        Refused{"vertex_count_of_a_hole_too_small", "3 0 0 9 0 0 9\n1\n2 1 1 2 1",
                "file:3:1: hole 1 of component 1 has 2 vertices; expected at least 3"},
        Refused{"vertex_count_zero_of_a_second_component", "3 0 0 9 0 0 9 0\n0\n",
                "file:2:1: outer chain of component 2 has 0 vertices; expected at least 3"},
        Refused{"vertex_count_too_large", "4\n0 0\n1 0\n0 1\n",
                "file:4:4: the end of the input after 3 of '4' vertices of outer chain of "
                "component 1; expected x of vertex 4 of outer chain of component 1"},
        Refused{"vertex_count_huge", "99999999999999 0 0 1 0 0 1",
                "file:1:27: the end of the input after 3 of '99999999999999' vertices of outer "
                "chain of component 1; expected x of vertex 4 of outer chain of component 1"},
        Refused{"vertex_count_beyond_any_integer", "99999999999999999999999999999999 0 0",
                "file:1:37: the end of the input after 1 of '99999999999999999999999999999999' "
                "vertices of outer chain of component 1; expected x of vertex 2 of outer chain of "
                "component 1"},
        Refused{"y_is_missing", "3\n0 0\n1 0\n0",
                "file:4:2: the end of the input after 2 of '3' vertices of outer chain of "
                "component 1; expected y of vertex 3 of outer chain of component 1"},
        Refused{"nothing_but_a_count", "3",
                "file:1:2: the end of the input after 0 of '3' vertices of outer chain of "
                "component 1; expected x of vertex 1 of outer chain of component 1"},
        Refused{"coordinate_is_not_a_number", "3\n0 0\n1 zero\n0 1\n",
                "file:3:3: y of vertex 2 of outer chain of component 1: 'zero' is not a number; "
                "expected an integer, a decimal or a fraction p/q"},
        Refused{"coordinate_with_comma", "3\n0,0\n1 0\n0 1\n",
                "file:2:1: x of vertex 1 of outer chain of component 1: '0,0' is not a number; "
                "expected an integer, a decimal or a fraction p/q"},
        Refused{
            "coordinate_of_a_hole", "3 0 0 9 0 0 9\n2\n3 1 1 1 2 2 1\n3 1 1 x 1 1 1",
            "file:4:7: x of vertex 2 of hole 2 of component 1: 'x' is not a number; expected an "
            "integer, a decimal or a fraction p/q"},
        Refused{"zero_denominator", "3\n0 0\n1/0 0\n0 1\n",
                "file:3:1: x of vertex 2 of outer chain of component 1: '1/0' has the denominator "
                "0; expected a fraction p/q with q > 0"},
        Refused{"not_a_number", "3\n0 0\nnan 0\n0 1\n",
                "file:3:1: x of vertex 2 of outer chain of component 1: 'nan' is not finite; "
                "expected a finite number"},
        Refused{"infinite", "3\n0 0\n1 -inf\n0 1\n",
                "file:3:3: y of vertex 2 of outer chain of component 1: '-inf' is not finite; "
                "expected a finite number"},
        Refused{"huge_exponent", "3\n0 0\n1e999999999999 0\n0 1\n",
                "file:3:1: x of vertex 2 of outer chain of component 1: '1e999999999999' has too "
                "large an exponent; expected an exponent from -4096 to 4096"},
        Refused{"hole_count_is_not_an_integer", "3 0 0 1 0 0 1\nmore",
                "file:2:1: 'more' where the number of holes of component 1 should be; expected an "
                "integer without a sign or the end of the input"},
        Refused{"vertex_more_than_counted", "3\n0 0\n1 0\n0 1\n-1 -1\n",
                "file:5:1: '-1' where the number of holes of component 1 should be; expected an "
                "integer without a sign or the end of the input"},
        Refused{"hole_missing", "3 0 0 9 0 0 9\n2\n3 1 1 1 2 2 1\n",
                "file:3:14: the end of the input after 1 of '2' holes of component 1; expected the "
                "number of vertices of hole 2 of component 1"},
        Refused{"hole_count_huge", "3 0 0 9 0 0 9\n88888888888888888888888\n",
                "file:2:24: the end of the input after 0 of '88888888888888888888888' holes of "
                "component 1; expected the number of vertices of hole 1 of component 1"},
        Refused{"hole_count_missing_of_a_second_component", "3 0 0 1 0 0 1 0\n3 5 5 6 5 5 6\n",
                "file:2:14: the end of the input where the number of holes of component 2 should "
                "be; expected an integer without a sign"},
        Refused{"garbage_after_a_component", "3 0 0 1 0 0 1\n0\n;",
                "file:3:1: ';' where the number of vertices of outer chain of component 2 should "
                "be; expected an integer without a sign"},
        Refused{"garbage_after_the_empty_region", "0\n3 0 0 1 0 0 1\n",
                "file:2:1: '3' after '0', the empty region; expected the end of the input"},
        Refused{"long_word_is_shortened", std::string(50, '?'),
                "file:1:1: '" + std::string(40, '?') +
                    "...' where the number of vertices of outer chain of component 1 should be; "
                    "expected an integer without a sign"},
        Refused{"word_beyond_ascii_is_escaped", "3 0 0 1 0 0 \xC3\xA9",
                "file:1:13: y of vertex 3 of outer chain of component 1: '\\xc3\\xa9' is not a "
                "number; expected an integer, a decimal or a fraction p/q"}),
    test_name);

}  // namespace
}  // namespace oplus
