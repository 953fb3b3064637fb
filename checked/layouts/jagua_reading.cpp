// SPDX-License-Identifier: MIT
#include <map>

#include "checked/layouts/builder.hpp"
#include "checked/layouts/json_fields.hpp"
#include "reference/io/quoting.hpp"

namespace oplus::layouts {

namespace {

Chain rectangle(const Point& low, const Rational& width, const Rational& height) {
  const Point high{low.x + width, low.y + height};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

PlacedChain at_one_place(const JsonFields& value, Chain vertices) {
  return {.vertices = vertices,
          .places = std::vector<Position>(vertices.size(), value.at()),
          .start = value.at()};
}

/// jagua-rs leaves out a vertex that equals the next one, also at the end.
PlacedChain chain(const JsonFields& value) {
  PlacedChain result{.start = value.at()};
  for (const JsonFields& vertex : value.items()) {
    Point p = vertex.point();
    if (!result.vertices.empty() && result.vertices.back() == p) continue;
    result.vertices.push_back(std::move(p));
    result.places.push_back(vertex.at());
  }
  remove_closing_vertex(result);
  result.is_open = false;
  return result;
}

void add(PlacedGeometry& geometry, std::size_t component, PlacedChain chain) {
  const bool is_hole =
      !geometry.chains.empty() && geometry.chains.back().name.component == component;
  chain.name = {component, is_hole ? geometry.chains.back().name.hole + 1 : 0};
  geometry.chains.push_back(std::move(chain));
}

void add_polygon(PlacedGeometry& geometry, const JsonFields& polygon) {
  const std::size_t component = geometry.next_component();
  add(geometry, component, chain(polygon["outer"]));
  if (const auto holes = polygon.find("inner"))
    for (const JsonFields& hole : holes->items()) add(geometry, component, chain(hole));
}

Region shape(Builder& builder, const JsonFields& shape) {
  const JsonFields type = shape["type"], data = shape["data"];
  PlacedGeometry geometry;
  if (type.text() == "rectangle")
    add(geometry, 1,
        at_one_place(data, rectangle({data["x_min"].number(), data["y_min"].number()},
                                     data["width"].number(), data["height"].number())));
  else if (type.text() == "simple_polygon")
    add(geometry, 1, chain(data));
  else if (type.text() == "polygon")
    add_polygon(geometry, data);
  else if (type.text() == "multi_polygon")
    for (const JsonFields& polygon : data.items()) add_polygon(geometry, polygon);
  else
    type.refuse("the type " + one_line(type.text()),
                "rectangle, simple_polygon, polygon or multi_polygon");
  return builder.region(std::move(geometry));
}

struct Item {
  Region shape;
  std::optional<int> least_quality;
};

using Containers = std::map<std::string, JsonFields>;

/// By their ids.
void add_containers(Containers& all, const JsonFields& list) {
  for (const JsonFields& container : list.items()) all.emplace(container["id"].label(), container);
}

void read_container(Builder& builder, const JsonFields& container) {
  Sheet& sheet = builder.layout.sheets.back();
  const std::string what = "container " + one_line(container["id"].label());
  naming(what, [&] {
    sheet.container = shape(builder, container["shape"]);
    if (const auto zones = container.find("zones"))
      for (const JsonFields& zone : zones->items())
        sheet.defects.push_back({shape(builder, zone["shape"]), zone["quality"].integer()});
  });
}

void read_placed(Builder& builder, const JsonFields& layout,
                 const std::map<std::string, Item>& items) {
  for (const JsonFields& placed : layout["placed_items"].items()) {
    const std::size_t number = builder.layout.sheets.back().parts.size() + 1;
    naming("part " + std::to_string(number), [&] {
      const JsonFields id = placed["item_id"], transformation = placed["transformation"];
      const auto item = items.find(id.label());
      if (item == items.end())
        id.refuse("there is no item " + one_line(id.label()), "the id of an item");
      AffineMap map = builder.rotation(transformation["rotation"].number());
      map.by = transformation["translation"].point();
      builder.place("item " + id.label(), placed.line(), &item->second, item->second.shape, map,
                    item->second.least_quality);
    });
  }
}

}  // namespace

void read_jagua(Builder& builder, const JsonFields& root) {
  std::map<std::string, Item> items;
  for (const JsonFields& item : root["items"].items()) {
    const std::string id = item["id"].label();
    naming("item " + one_line(id), [&] {
      const auto quality = item.find("min_quality");
      const bool has_quality = quality && quality->value().kind() != JsonValue::Kind::null;
      items.emplace(id, Item{shape(builder, item["shape"]),
                             has_quality ? std::optional(quality->integer()) : std::nullopt});
    });
  }
  const auto solution = root.find("solution");
  if (!solution) root.refuse("items without a 'solution'", "where the items are placed");
  if (const auto strip = solution->find("layout")) {
    Sheet& sheet = builder.layout.sheets.back();
    PlacedGeometry geometry;
    add(geometry, 1,
        at_one_place(*solution, rectangle({}, (*solution)["strip_width"].number(),
                                          root["strip_height"].number())));
    sheet.container = naming("strip", [&] { return builder.region(std::move(geometry)); });
    return read_placed(builder, *strip, items);
  }
  Containers containers;
  if (const auto bins = root.find("bins")) add_containers(containers, *bins);
  if (const auto strips = solution->find("containers")) add_containers(containers, *strips);
  builder.layout.sheets.clear();
  for (const JsonFields& layout : (*solution)["layouts"].items()) {
    Sheet& sheet = builder.layout.sheets.emplace_back();
    sheet.name = "layout " + std::to_string(builder.layout.sheets.size());
    const JsonFields id = layout["container_id"];
    const auto container = containers.find(id.label());
    if (container == containers.end())
      id.refuse("there is no container " + one_line(id.label()), "the id of one");
    read_container(builder, container->second);
    read_placed(builder, layout, items);
  }
}

}  // namespace oplus::layouts
