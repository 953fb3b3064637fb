// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "checked/layouts/builder.hpp"
#include "checked/layouts/svg_document.hpp"
#include "checked/operations/image.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/quoting.hpp"

namespace oplus::layouts {

namespace {

/// The map that an attribute `transform` stands for: translate, scale, rotate and matrix, the last one first.
/// Throws InvalidInput, with a place in the text.
AffineMap svg_transform(Builder& builder, std::string_view text) {
  const InputText input{builder.input.name, text};
  Tokenizer tokens(input, "(),");
  AffineMap all;
  while (!tokens.peek().is_end()) {
    const Token name = tokens.take();
    if (name.text == ",") continue;
    if (const Token open = tokens.take(); open.text != "(")
      input.refuse(open.at, describe(open) + " after " + quote(name.text), "'('");
    std::vector<Rational> n;
    while (tokens.peek().text != ")") {
      const Token token = tokens.take();
      if (token.is_end()) input.refuse(token.at, "the end of a transform", "')'");
      if (token.text != ",")
        put_coordinate(input, token.text, token.at, n.emplace_back(),
                       [&] { return "a number of " + one_line(name.text); });
    }
    tokens.take();
    const auto is = [&](const char* step, std::size_t least, std::size_t most) {
      return name.text == step && (n.size() == least || n.size() == most);
    };
    const auto moved = [](Rational x, Rational y) {
      return AffineMap{1, 0, 0, 1, {std::move(x), std::move(y)}};
    };
    if (is("translate", 1, 2))
      all = all * moved(n[0], n.size() == 2 ? n[1] : Rational(0));
    else if (is("scale", 1, 2))
      all = all * AffineMap{n[0], 0, 0, n.back(), {}};
    else if (is("matrix", 6, 6))
      all = all * AffineMap{n[0], n[2], n[1], n[3], {n[4], n[5]}};
    else if (is("rotate", 1, 1))
      all = all * builder.rotation(n[0]);
    else if (is("rotate", 3, 3))
      all = all * moved(n[1], n[2]) * builder.rotation(n[0]) * moved(-n[1], -n[2]);
    else
      input.refuse(name.at, quote(name.text) + " of " + std::to_string(n.size()) + " numbers",
                   "translate, scale, rotate or matrix of as many as it takes");
  }
  return all;
}

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t i = words.find(word); i < words.size(); i = words.find(word, i + 1)) {
    const std::size_t end = i + word.size();
    if ((i == 0 || is_blank(words[i - 1])) && (end == words.size() || is_blank(words[end])))
      return true;
  }
  return false;
}

/// As SVGnest's class and the groups of sparrow call it: "bin", "bin_0", "container_0", "sheet".
bool is_container(const Element& element) {
  std::string_view id = SvgDocument::value(element, "id");
  id = id.substr(0, id.find_last_not_of("0123456789_-") + 1);
  const std::string_view classes = SvgDocument::value(element, "class");
  constexpr std::array names{"bin", "container", "sheet"};
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view name) { return id == name || has_word(classes, name); });
}

bool is_hidden(const Element& element) {
  std::string style(SvgDocument::value(element, "style"));
  std::erase_if(style, is_blank);
  return SvgDocument::value(element, "display") == "none" ||
         style.find("display:none") != std::string::npos ||
         SvgDocument::value(element, "id") == "optionals";  // what sparrow draws over a layout
}

bool is_hole(const Element& element) {
  return has_word(SvgDocument::value(element, "class"), "hole");
}

struct Around {
  AffineMap map = {};
  bool is_container = false;
  std::string label = {};
  std::size_t uses = 0;  ///< how many elements use are around it
  std::size_t line = 0;  ///< of the first of them
};

class SvgReader {
 public:
  explicit SvgReader(Builder& builder) : builder_(builder), document_(builder.input) {}

  void read() {
    children(document_.root(), {});
    if (lines_ > 0)
      builder_.layout.notes.push_back(one_line(builder_.input.name) + ": " +
                                      counted(lines_, "line was", "lines were") +
                                      " left out: they have no area");
  }

 private:
  void children(const Element& element, const Around& around) {
    for (const Element* child = element.first_node(); child != nullptr;
         child = child->next_sibling())
      if (child->type() == xml::node_element) read(*child, around);
  }

  void read(const Element& element, Around around) {
    constexpr std::size_t most = 10'000'000;
    const auto refuse = [&](const std::string& wrong, const std::string& expected) {
      builder_.input.refuse(document_.at(element), wrong, expected);
    };
    if (++elements_ > most)
      refuse(
          "more than " + std::to_string(most) + " elements, those that are used counted each time",
          "fewer");
    const std::string_view name = local_name(element);
    if (is_hidden(element)) return;
    if (const std::string_view id = document_.value(element, "id"); !id.empty()) around.label = id;
    around.is_container = around.is_container || is_container(element);
    if (around.label == "quality_zones" && element.first_node() != nullptr)
      refuse("quality zones",
             "a layout without them, or JSON, which says which part needs which quality");
    if (name == "svg") refuse("an svg inside another one", "elements svg only around all others");
    const bool is_shape = name == "path" || name == "polygon" || name == "rect";
    if (!is_shape && name != "g" && name != "a" && name != "use") {
      if (name == "circle" || name == "ellipse")
        refuse("the element " + std::string(name) + " is a curve",
               "straight segments: paths, polygons and rectangles");
      if (name == "switch" || (name == "symbol" && around.uses > 0))
        refuse("the element " + one_line(name), "g");
      lines_ += name == "line" || name == "polyline" ? 1 : 0;
      return;  // what has no area, or is drawn only where it is used
    }
    if (const std::string_view text = document_.value(element, "transform"); !text.empty())
      around.map = around.map * naming(
                                    "", [&] { return svg_transform(builder_, text); },
                                    document_.at(element, "transform"));
    if (name == "use")
      use(element, around);
    else if (is_shape)
      shape(element, around);
    else
      children(element, around);
  }

  void use(const Element& element, Around around) {
    constexpr std::size_t deepest = 16;
    const bool has_href = element.first_attribute("href") != nullptr;
    const char* reference = has_href ? "href" : "xlink:href";
    const std::string_view href = document_.value(element, reference);
    const auto refuse = [&](const std::string& wrong, const std::string& expected) {
      builder_.input.refuse(document_.at(element, reference), wrong, expected);
    };
    if (!href.starts_with('#'))
      refuse("the reference " + quote(href), "the id of an element, as #part");
    const auto [known, is_new] = used_.try_emplace(std::string(href.substr(1)));
    if (is_new) known->second = document_.find(known->first);
    if (known->second == nullptr)
      refuse("there is no part " + quote(known->first), "the id of an element");
    if (++around.uses > deepest)
      refuse("elements that use each other, deeper than " + std::to_string(deepest) + " levels",
             "fewer");
    if (around.uses == 1) around.line = document_.at(element).line;
    around.map = around.map * AffineMap{1, 0, 0, 1, {length(element, "x"), length(element, "y")}};
    read(*known->second, around);
  }

  /// 0 where it is missing.
  Rational length(const Element& element, const char* attribute) const {
    Rational value;
    if (element.first_attribute(attribute) != nullptr)
      put_coordinate(builder_.input, document_.value(element, attribute),
                     document_.at(element, attribute), value,
                     [&] { return std::string(attribute); });
    return value;
  }

  /// What the element draws.
  PlacedGeometry drawn(const Element& element) {
    const std::string& name = builder_.input.name;
    if (local_name(element) == "rect") {
      for (const char* radius : {"rx", "ry"})
        if (length(element, radius) != 0)
          builder_.input.refuse(document_.at(element, radius), "a rectangle with round corners",
                                "straight segments");
      const Point low{length(element, "x"), length(element, "y")};
      const Point high{low.x + length(element, "width"), low.y + length(element, "height")};
      PlacedGeometry result;
      result.chains.push_back({.vertices = {low, {high.x, low.y}, high, {low.x, high.y}},
                               .places = std::vector<Position>(4, document_.at(element)),
                               .start = document_.at(element)});
      return result;
    }
    if (local_name(element) == "path")
      return parse_svg_path({name, document_.value(element, "d")}, Overlaps::refused);
    const std::string path = "M" + std::string(document_.value(element, "points")) + "Z";
    return parse_svg_path({name, path}, Overlaps::refused);
  }

  /// With the holes that follow it as elements of their own.
  const Region& region(const Element& element) {
    const auto [known, is_new] = regions_.try_emplace(&element);
    if (!is_new) return known->second;
    const auto part = [&](const Element& of) {
      const std::string_view name = local_name(of);
      Position start = document_.at(of, name == "path" ? "d" : "points");
      if (name == "rect") start = {};
      if (name == "polygon") --start.column;
      PlacedGeometry geometry = naming(
          "", [&] { return drawn(of); }, start);
      for (PlacedChain& chain : geometry.chains) {
        chain.start = shifted(chain.start, start);
        for (Position& at : chain.places) at = shifted(at, start);
      }
      return geometry;
    };
    PlacedGeometry all = part(element);
    for (const Element* next = element.next_sibling();
         next != nullptr && is_hole(*next) && !all.chains.empty(); next = next->next_sibling()) {
      if (document_.value(*next, "transform") != document_.value(element, "transform"))
        builder_.input.refuse(document_.at(*next), "a hole with a transform of its own",
                              "that of the element around it");
      for (PlacedChain& hole : part(*next).chains) {
        hole.name = {1, all.chains.back().name.hole + 1};
        all.chains.push_back(std::move(hole));
      }
    }
    return known->second = builder_.region(std::move(all));
  }

  void shape(const Element& element, const Around& around) {
    if (is_hole(element) && element.previous_sibling() != nullptr) return;
    Sheet& sheet = builder_.layout.sheets.back();
    const std::string what =
        around.is_container ? "container" : "part " + std::to_string(sheet.parts.size() + 1);
    const Region* original = naming(what, [&] { return &region(element); });
    if (original->components.empty()) return;
    if (around.map.determinant() == 0)
      builder_.input.refuse(document_.at(element), what + " is flat after its transform",
                            "a part with area");
    if (!around.is_container)
      return builder_.place(around.label,
                            around.uses > 0 ? around.line : document_.at(element).line, original,
                            *original, around.map);
    if (sheet.container)
      builder_.input.refuse(document_.at(element), "a second container", "one for all parts");
    sheet.container = image(around.map, *original);
  }

  Builder& builder_;
  SvgDocument document_;
  std::size_t elements_ = 0, lines_ = 0;
  std::map<std::string, const Element*> used_;
  std::map<const Element*, Region> regions_;
};

}  // namespace

void read_svg(Builder& builder) { SvgReader(builder).read(); }

}  // namespace oplus::layouts
