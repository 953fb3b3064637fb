// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace oplus {

/// The document as a tree; throws where it is not well formed.
inline boost::property_tree::ptree parsed(const std::string& document) {
  std::istringstream in(document);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(in, tree);
  return tree.get_child("svg");
}

/// The groups of a class directly in another element.
inline std::vector<boost::property_tree::ptree> groups(const boost::property_tree::ptree& tree,
                                                       const std::string& name) {
  std::vector<boost::property_tree::ptree> found;
  for (const auto& [tag, child] : tree) {
    if (tag == "g" && child.get<std::string>("<xmlattr>.class") == name) found.push_back(child);
  }
  return found;
}

/// The texts of the legend.
inline std::multiset<std::string> legend_of(const boost::property_tree::ptree& tree) {
  std::multiset<std::string> labels;
  const boost::property_tree::ptree legend = groups(tree, "legend").at(0);
  for (const auto& [tag, child] : legend)
    if (tag == "text") labels.insert(child.data());
  return labels;
}

}  // namespace oplus
