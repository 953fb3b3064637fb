// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/region_lines.hpp"

#include <gtest/gtest.h>

#include "reference/io/invalid_input.hpp"
#include "tests/checked/cli/shell.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

class RegionLines : public Shell {
 protected:
  std::string message_for(const std::string& lines) {
    put("parts.wkt", lines);
    return refusal([&] { read_region_lines(path()); });
  }

  std::string path() const { return folder() / "parts.wkt"; }
};

TEST_F(RegionLines, are_regions_but_for_blank_ones) {
  put("parts.wkt", "POLYGON((0 0,1 0,0 1,0 0))\n \r\n\n[[0,0],[2.5,0],[0,1]]\n");
  EXPECT_EQ(read_region_lines(path()),
            (std::vector<Region>{polygon({{0, 0}, {1, 0}, {0, 1}}),
                                 polygon({{0, 0}, {Rational(5, 2), 0}, {0, 1}})}));
}

TEST_F(RegionLines, messages_have_the_line) {
  EXPECT_TRUE(has(message_for("POLYGON((0 0,1 0,0 1,0 0))\n\nPOLYGON((0 0,1 0,x 1,0 0))\n"),
                  "parts.wkt:3:"));
  EXPECT_TRUE(has(message_for("\n"), "it is empty"));
}

}  // namespace
}  // namespace oplus
