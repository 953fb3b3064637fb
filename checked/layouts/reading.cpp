// SPDX-License-Identifier: MIT
#include "checked/layouts/reading.hpp"

#include "checked/layouts/builder.hpp"
#include "checked/layouts/json_fields.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

using namespace layouts;

constexpr const char* formats =
    "a layout: polygons, JSON with 'parts' and 'placements', JSON of jagua-rs, sparrow or packingsolver, or SVG";

/// Of the first of several objects in lines; the reader of GeoJSON takes them all.
void read_json(Builder& builder, const std::string& text) {
  TextPlace place;
  const JsonTree tree(builder.input, place);
  const JsonFields root(builder.input, tree.root(), "the layout");
  if (root.find("type")) return read_polygons(builder, text);
  const bool is_jagua = root.find("items").has_value(),
             is_packingsolver = root.find("bins").has_value();
  if (!is_jagua && !is_packingsolver && !root.find("placements"))
    root.refuse("an object without 'placements', 'items' and 'bins'", formats);
  const JsonTree alone(builder.input);
  (is_jagua           ? read_jagua
   : is_packingsolver ? read_packingsolver
                      : read_placements)(builder, {builder.input, alone.root(), "the layout"});
}

}  // namespace

Layout read_layout(const std::string& text, const std::string& name,
                   const std::filesystem::path& folder, const Rational& angle_error) {
  const std::string_view content = without_byte_order_mark(text);
  const InputText input{name, content};
  Builder builder(input, folder, angle_error);
  const std::size_t first = content.find_first_not_of(blanks);
  const char start = first == std::string_view::npos ? ' ' : content[first];
  if (start == '{' || start == '<') {
    if (const std::size_t zero = content.find('\0'); zero != std::string_view::npos) {
      Position at;
      for (const char c : content.substr(0, zero)) at.pass(c);
      input.refuse(at, "the byte " + quote(content.substr(zero, 1)) + " is not text", formats);
    }
  }
  if (start == '{')
    read_json(builder, text);
  else if (start == '<')
    read_svg(builder);
  else
    read_polygons(builder, text);
  return builder.finish();
}

Layout read_layout_file(const std::string& path, const Rational& angle_error) {
  return read_layout(input_text(path, formats), input_name(path),
                     std::filesystem::path(path).parent_path(), angle_error);
}

}  // namespace oplus
