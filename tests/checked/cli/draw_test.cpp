// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Draw : public Shell {
 protected:
  void SetUp() override {
    Shell::SetUp();
    put("frame.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))");
    put("triangle.dat", "3\n0 0\n1 0\n0 1/3\n");
    put("<odd> & \xff name.wkt", "POLYGON EMPTY");
  }
};

TEST_F(Draw, has_a_panel_a_file) {
  const Ran ran = run("oplus draw frame.wkt triangle.dat *odd* - -o all.svg <triangle.dat");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.out + ran.err, "");
  std::istringstream in(content("all.svg"));
  boost::property_tree::ptree document;
  boost::property_tree::read_xml(in, document);
  std::set<std::string> titles;
  for (const auto& [tag, child] : document.get_child("svg")) {
    if (tag == "g" && child.get<std::string>("<xmlattr>.class") == "panel")
      titles.insert(child.get<std::string>("text"));
  }
  EXPECT_EQ(titles, (std::set<std::string>{"frame.wkt", "triangle.dat", "<odd> & ? name.wkt",
                                           "standard input"}));
}

TEST_F(Draw, writes_to_standard_output) {
  EXPECT_EQ(run("oplus draw frame.wkt -o -").out.substr(0, 5), "<svg ");
}

TEST_F(Draw, refuses_what_cannot_be_drawn) {
  expect_refusal("oplus draw frame.wkt", "--output");
  expect_refusal("oplus draw -o all.svg", "FILE");
  expect_refusal("oplus draw frame.wkt missing.wkt -o all.svg", "missing.wkt");
  expect_refusal("oplus draw frame.wkt -o missing/all.svg", "missing");
  expect_refusal("oplus draw - - -o all.svg <frame.wkt", "standard input");
}

}  // namespace
}  // namespace oplus
