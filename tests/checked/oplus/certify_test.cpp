// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/engines.hpp"

namespace oplus {
namespace {

const ValidRegion square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});

std::string refusal(const GivenSum& given) {
  try {
    certify(square, square, given);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(Certify, a_certificate_of_the_sum) {
  const std::string text =
      certify(square, square, {minkowski_sum(square, square).region().region(), {}, {}});
  EXPECT_TRUE(text.starts_with("oplus certificate 1\nunit 1\nsummand p\n"));
  EXPECT_TRUE(text.ends_with("\nend\n"));
}

TEST(Certify, fractions_need_not_be_in_lowest_terms) {
  Rational two;
  two.get_num() = 4;
  two.get_den() = 2;
  GivenSum given;
  given.region.components = {{{{0, 0}, {two, 0}, {two, two}, {0, two}}, {}}};
  EXPECT_EQ(certify(square, square, given),
            certify(square, square, {polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}).region(), {}, {}}));
}

TEST(Certify, what_is_not_the_sum_is_refused_with_the_reason) {
  EXPECT_TRUE(refusal({square.region(), {}, {}}).starts_with("S: it is not the sum: "));
  GivenSum with_point = {minkowski_sum(square, square).region().region(), {}, {{5, 5}}};
  EXPECT_TRUE(
      refusal(with_point).starts_with("S: it is not the sum: additional isolated vertex: "));
}

TEST(Certify, a_vertex_may_not_repeat_the_one_before) {
  GivenSum given;
  given.region.components = {{{{0, 0}, {0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}}};
  EXPECT_EQ(refusal(given), "S: the vertex (0, 0) twice in a row; expected an edge between them");
}

TEST(Certify, summands_are_bounded) {
  EXPECT_THROW(certify(complement(square), square, {}), InvalidInput);
}

}  // namespace
}  // namespace oplus
