// SPDX-License-Identifier: MIT
#include "checked/layouts/builder.hpp"
#include "checked/layouts/json_fields.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/writing.hpp"

namespace oplus::layouts {

namespace {

/// Of line segments, each of which starts where the one before it ends.
PlacedChain chain(const JsonFields& elements, const ChainName& name) {
  PlacedChain result{.name = name, .start = elements.at()};
  std::optional<Point> first, end;
  const auto follow = [&](const JsonFields& element, const Point& start) {
    if (end && *end != start)
      element.refuse("an element starts at " + to_string(start) +
                         ", and the one before it ends at " + to_string(*end),
                     "a closed chain");
  };
  const std::vector<JsonFields> all = elements.items();
  for (const JsonFields& element : all) {
    const JsonFields type = element["type"];
    if (type.text() != "LineSegment")
      type.refuse("an element of the type " + one_line(type.text()) + " is a curve", "LineSegment");
    const Point start{element["xs"].number(), element["ys"].number()};
    follow(element, start);
    end = {element["xe"].number(), element["ye"].number()};
    result.vertices.push_back(start);
    result.places.push_back(element.at());
  }
  if (!all.empty()) follow(all.front(), result.vertices.front());
  return result;
}

void add(PlacedGeometry& geometry, const JsonFields& shape) {
  ChainName name{geometry.next_component(), 0};
  geometry.chains.push_back(chain(shape["shape"], name));
  if (const auto holes = shape.find("holes"))
    for (const JsonFields& hole : holes->items()) {
      ++name.hole;
      geometry.chains.push_back(chain(hole, name));
    }
}

}  // namespace

void read_packingsolver(Builder& builder, const JsonFields& root) {
  std::vector<Sheet>& sheets = builder.layout.sheets;
  sheets.clear();
  for (const JsonFields& bin : root["bins"].items()) {
    Sheet& sheet = sheets.emplace_back();
    sheet.name = "bin " + std::to_string(sheets.size());
    naming(sheet.name, [&] {
      PlacedGeometry container;
      add(container, bin);
      sheet.container = builder.region(std::move(container));
      if (const auto defects = bin.find("defects"))
        for (const JsonFields& defect : defects->items()) {
          PlacedGeometry geometry;
          add(geometry, defect);
          sheet.defects.push_back({builder.region(std::move(geometry))});
        }
      if (const auto items = bin.find("items"))
        for (const JsonFields& item : items->items())
          naming("part " + std::to_string(sheet.parts.size() + 1), [&] {
            PlacedGeometry geometry;
            for (const JsonFields& shape : item["item_shapes"].items()) add(geometry, shape);
            builder.place("item " + item["id"].label(), item.line(), nullptr,
                          builder.region(std::move(geometry)), {});
          });
    });
  }
}

}  // namespace oplus::layouts
