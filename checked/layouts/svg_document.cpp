// SPDX-License-Identifier: MIT
#include "checked/layouts/svg_document.hpp"

#include <algorithm>

namespace oplus::layouts {

SvgDocument::SvgDocument(const InputText& input)
    : input_(input),
      text_(input.text),
      line_starts_{0},
      document_(std::make_unique<xml::xml_document<char>>()) {
  for (std::size_t i = 0; i < text_.size(); ++i)
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  refuse_deep_nesting();
  try {
    // No text, not even blanks, is between siblings.
    document_->parse<xml::parse_validate_closing_tags | xml::parse_no_data_nodes>(text_.data());
  } catch (const xml::parse_error& error) {
    input.refuse(at(error.where<char>()), error.what(), "an SVG file");
  }
  if (document_->first_node() == nullptr || local_name(root()) != "svg")
    input.refuse({}, "markup without an element svg", "an SVG file");
}

Position SvgDocument::at(const char* place) const {
  const auto offset = static_cast<std::size_t>(place - text_.data());
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return {static_cast<std::size_t>(after - line_starts_.begin()), offset - *std::prev(after) + 1};
}

std::string_view SvgDocument::value(const Element& element, const char* attribute) {
  const xml::xml_attribute<char>* found = element.first_attribute(attribute);
  return found == nullptr ? std::string_view()
                          : std::string_view(found->value(), found->value_size());
}

Position SvgDocument::at(const Element& element, const char* attribute) const {
  const xml::xml_attribute<char>* found = element.first_attribute(attribute);
  return at(found == nullptr ? element.name() : found->value());
}

const Element* SvgDocument::find(std::string_view id) const {
  // From an element to its first child, its next sibling, or that of one around it.
  for (const Element* here = &root(); here != nullptr;) {
    if (value(*here, "id") == id) return here;
    const Element* next = here->first_node();
    for (; next == nullptr && here != nullptr && here != &root(); here = here->parent())
      next = here->next_sibling();
    if (next == nullptr) return nullptr;
    here = next;
  }
  return nullptr;
}

/// The parser calls itself for each level. Up to what it refuses, it sees tags as this does.
void SvgDocument::refuse_deep_nesting() const {
  constexpr std::size_t deepest = 256;
  const std::string_view text = input_.text;
  std::size_t depth = 0;
  for (std::size_t start = text.find('<'), end = 0; start < text.size();
       start = text.find('<', end)) {
    const std::string_view rest = text.substr(start);
    if (rest.starts_with("<!--")) {
      end = text.find("-->", start + 4);
    } else if (rest.starts_with("<![CDATA[")) {
      end = text.find("]]>", start);
    } else if (rest.starts_with("<?")) {
      end = text.find("?>", start);
    } else {
      char quote = '\0';
      for (end = start + 1; end < text.size() && (quote != '\0' || text[end] != '>'); ++end) {
        if (text[end] == quote)
          quote = '\0';
        else if (quote == '\0' && (text[end] == '"' || text[end] == '\''))
          quote = text[end];
      }
      if (rest.starts_with("<!")) {
        if (text.substr(start, end - start).find('[') != std::string_view::npos)
          input_.refuse(at(text_.data() + start), "a document type with declarations", "none");
      } else if (rest.starts_with("</")) {
        depth -= std::min<std::size_t>(depth, 1);
      } else if (text[std::min(end, text.size()) - 1] != '/' && ++depth > deepest) {
        input_.refuse(at(text_.data() + start),
                      "elements nested deeper than " + std::to_string(deepest) + " levels",
                      "an SVG file");
      }
    }
    if (end >= text.size()) return;
  }
}

std::string_view local_name(const Element& element) {
  const std::string_view name(element.name(), element.name_size());
  return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

}  // namespace oplus::layouts
