// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/pictures/stacked_pictures.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/reference/pictures/parsed_picture.hpp"

namespace oplus {
namespace {

using boost::property_tree::ptree;

std::string picture(int width, int height) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width) +
         "\" height=\"" + std::to_string(height) + ".50\"><g id=\"" + std::to_string(width) +
         "\"/></svg>\n";
}

TEST(StackedPictures, stand_one_below_another_and_fit_on_the_page) {
  const ptree page =
      parsed(stacked({{"first", picture(300, 100)}, {"<second>", picture(400, 50)}}));
  std::vector<std::string> titles;
  double bottom = 0;
  double title_at = 0;
  for (const auto& [tag, child] : page) {
    if (tag == "text") {
      titles.push_back(child.data());
      title_at = child.get<double>("<xmlattr>.y");
      EXPECT_GT(title_at, bottom);
    }
    if (tag == "svg") {
      const auto top = child.get<double>("<xmlattr>.y");
      EXPECT_GE(top, title_at);
      bottom = top + child.get<double>("<xmlattr>.height");
      EXPECT_EQ(child.get<std::string>("g.<xmlattr>.id"),
                child.get<std::string>("<xmlattr>.width"));
    }
  }
  EXPECT_EQ(titles, (std::vector<std::string>{"first", "<second>"}));
  EXPECT_GE(page.get<double>("<xmlattr>.height"), bottom);
  EXPECT_GE(page.get<double>("<xmlattr>.width"), 400);
}

TEST(StackedPictures, none_are_a_picture_too) { EXPECT_EQ(parsed(stacked({})).count("svg"), 0U); }

TEST(StackedPictures, need_their_size) {
  for (const std::string wrong :
       {"", "<svg/>", "<svg width=\"3\">", "<svg height=\"3\">", "<g width=\"3\" height=\"3\"/>",
        "<svg width=\"wide\" height=\"3\">", "<svg><g width=\"3\" height=\"3\"/></svg>"})
    EXPECT_THROW(stacked({{"", wrong}}), std::invalid_argument) << wrong;
}

}  // namespace
}  // namespace oplus
