// SPDX-License-Identifier: MIT
#pragma once

#include <boost/property_tree/detail/rapidxml.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "reference/io/input_text.hpp"

namespace oplus::layouts {

namespace xml = boost::property_tree::detail::rapidxml;
using Element = xml::xml_node<char>;

/// The elements of an SVG file, and where they are. RapidXml, as Boost has it, leaves names and values in their places.
class SvgDocument {
 public:
  /// Throws InvalidInput where the text is not XML, or elements are nested too deep. The input must outlive it.
  explicit SvgDocument(const InputText& input);

  const Element& root() const { return *document_->first_node(); }
  Position at(const Element& element) const { return at(element.name()); }
  /// The value of an attribute, "" where it is missing; and where it is.
  static std::string_view value(const Element& element, const char* attribute);
  Position at(const Element& element, const char* attribute) const;

  /// The element with an id, or null.
  const Element* find(std::string_view id) const;

 private:
  Position at(const char* place) const;
  void refuse_deep_nesting() const;

  const InputText& input_;
  std::string text_;                      ///< in which the parser marks ends
  std::vector<std::size_t> line_starts_;  ///< of the input
  std::unique_ptr<xml::xml_document<char>> document_;
};

/// The name without the prefix of a namespace.
std::string_view local_name(const Element& element);

}  // namespace oplus::layouts
