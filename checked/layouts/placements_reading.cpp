// SPDX-License-Identifier: MIT
#include <map>

#include "checked/layouts/builder.hpp"
#include "checked/layouts/json_fields.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/unchecked_input.hpp"

namespace oplus::layouts {

namespace {

/// GeoJSON or an array; a string that contains any other form; or {"file": PATH}, from the layout's folder.
Region shape(Builder& builder, const JsonFields& value, const std::string& what) {
  if (value.value().kind() == JsonValue::Kind::string)
    return naming(
        what,
        [&] { return builder.region(read_unchecked(value.text(), builder.input.name).geometry); },
        {value.line(), value.at().column + 1});
  return naming(what, [&] {
    if (value.value().kind() == JsonValue::Kind::object)
      if (const auto file = value.find("file"))
        return read_region_file((builder.folder / file->text()).string()).region;
    return builder.region(parse_geojson(builder.input, value.value()));
  });
}

/// By degrees, or by a cosine and a sine.
AffineMap rotation(Builder& builder, const JsonFields& value) {
  if (value.value().kind() != JsonValue::Kind::array) return builder.rotation(value.number());
  const auto [cos, sin] = value.point();
  if (cos * cos + sin * sin != 1)
    value.refuse("a cosine and a sine whose squares don't add up to 1", "those of a rotation");
  return {cos, -sin, sin, cos};
}

}  // namespace

void read_placements(Builder& builder, const JsonFields& root) {
  Sheet& sheet = builder.layout.sheets.back();
  if (const auto container = root.find("container"))
    sheet.container = shape(builder, *container, "container");
  if (const auto defects = root.find("defects"))
    for (const JsonFields& defect : defects->items())
      sheet.defects.push_back({shape(builder, defect, "defect")});
  std::map<std::string, Region> parts;
  for (const auto& [name, value] : root["parts"].members())
    parts.emplace(name, shape(builder, value, "part " + quote(name)));
  for (const JsonFields& placement : root["placements"].items()) {
    const std::string what = "placement " + std::to_string(sheet.parts.size() + 1);
    naming(what, [&] {
      const JsonFields name = placement["part"];
      const auto part = parts.find(name.label());
      if (part == parts.end())
        name.refuse("there is no part " + quote(name.label()), "a name that 'parts' has");
      AffineMap map;
      if (const auto turn = placement.find("rotation")) map = rotation(builder, *turn);
      if (const auto mirrored = placement.find("mirrored")) {
        if (mirrored->value().kind() != JsonValue::Kind::boolean)
          mirrored->refuse("'mirrored' is " + describe(mirrored->value().kind()), "true or false");
        if (mirrored->value().text() == "true") map = map * AffineMap{-1, 0, 0, 1, {}};
      }
      if (const auto at = placement.find("at")) map.by = at->point();
      builder.place(part->first, placement.line(), &part->second, part->second, map);
    });
  }
}

}  // namespace oplus::layouts
