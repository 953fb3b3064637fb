// SPDX-License-Identifier: MIT
#include <string>
#include <utility>

#include "reference/io/counted.hpp"
#include "reference/io/json_tree.hpp"
#include "reference/io/placed_geometry.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

using Kind = JsonValue::Kind;

class GeoJsonReader {
 public:
  GeoJsonReader(const InputText& input, Wanted wanted) : input_(input), wanted_(wanted) {}

  PlacedGeometry read() {
    JsonValue tree = parse_json(input_);
    geometry(tree, wanted_ == Wanted::sum);
    return std::move(result_);
  }

 private:
  void geometry(JsonValue& value, bool may_be_collection) {
    require(value, Kind::object, "a geometry");
    const JsonValue& type = member(value, "type");
    require(type, Kind::string, "the type of a geometry");
    const bool sum = wanted_ == Wanted::sum;
    if (type.text == "Polygon") {
      JsonValue& rings = coordinates(value, type);
      if (!rings.items.empty()) polygon(rings);
    } else if (type.text == "MultiPolygon") {
      for (JsonValue& rings : coordinates(value, type).items) polygon(rings);
    } else if (sum && type.text == "LineString") {
      line_string(coordinates(value, type));
    } else if (sum && type.text == "MultiLineString") {
      for (JsonValue& line : coordinates(value, type).items) line_string(line);
    } else if (sum && type.text == "Point") {
      point(coordinates(value, type));
    } else if (sum && type.text == "MultiPoint") {
      for (const JsonValue& position : coordinates(value, type).items) point(position);
    } else if (may_be_collection && type.text == "GeometryCollection") {
      JsonValue& geometries = member(value, "geometries");
      require(geometries, Kind::array, "'geometries' of a GeometryCollection");
      for (JsonValue& of_collection : geometries.items) geometry(of_collection, false);
    } else {
      input_.refuse(type.at, "the type " + quote(type.text),
                    !sum                ? "Polygon or MultiPolygon"
                    : may_be_collection ? "(Multi)Polygon, (Multi)LineString, (Multi)Point or "
                                          "GeometryCollection"
                                        : "(Multi)Polygon, (Multi)LineString or (Multi)Point");
    }
  }

  JsonValue& member(JsonValue& object, const std::string& key) {
    JsonValue* found = object.member(key);
    if (found == nullptr)
      input_.refuse(object.at, "an object without " + quote(key), "a GeoJSON geometry");
    return *found;
  }

  JsonValue& coordinates(JsonValue& geometry, const JsonValue& type) {
    JsonValue& value = member(geometry, "coordinates");
    require(value, Kind::array, "'coordinates' of a " + type.text);
    return value;
  }

  void require(const JsonValue& value, Kind kind, const std::string& what) {
    if (value.kind != kind)
      input_.refuse(value.at, what + " is " + describe(value.kind), describe(kind));
  }

  void polygon(JsonValue& rings) {
    ChainName name{result_.next_component(), 0};
    require(rings, Kind::array, "component " + std::to_string(name.component));
    if (rings.items.empty())
      input_.refuse(rings.at, "component " + std::to_string(name.component) + " has no chain",
                    "an outer chain");
    for (JsonValue& item : rings.items) {
      result_.chains.push_back(ring(item, name));
      ++name.hole;
    }
  }

  PlacedChain ring(JsonValue& positions, const ChainName& name) {
    PlacedChain chain = vertices_of(positions, describe(name));
    chain.name = name;
    remove_closing_vertex(input_, chain);
    return chain;
  }

  void line_string(JsonValue& positions) {
    const std::string number = std::to_string(result_.line_strings.size() + 1);
    result_.line_strings.push_back(vertices_of(positions, "line string " + number));
  }

  void point(const JsonValue& position) {
    const std::string number = std::to_string(result_.points.vertices.size() + 1);
    add_vertex(result_.points, position, [&] { return "point " + number; });
  }

  /// Frees each position once it is read: the tree takes more memory than the chain.
  PlacedChain vertices_of(JsonValue& positions, const std::string& name) {
    require(positions, Kind::array, name);
    PlacedChain chain{.start = positions.at};
    chain.vertices.reserve(positions.items.size());
    chain.places.reserve(positions.items.size());
    for (JsonValue& position : positions.items) {
      add_vertex(chain, position, [&] {
        return "vertex " + std::to_string(chain.vertices.size() + 1) + " of " + name;
      });
      position.items = {};
    }
    return chain;
  }

  template <typename Name>
  void add_vertex(PlacedChain& chain, const JsonValue& position, Name name) {
    if (position.kind != Kind::array)
      input_.refuse(position.at, name() + " is " + describe(position.kind), "an array [x, y]");
    if (position.items.size() != 2)
      input_.refuse(position.at,
                    name() + " has " + counted(position.items.size(), "coordinate", "coordinates"),
                    "an array [x, y]");
    Rational x = number(position.items[0], [&] { return "x of " + name(); });
    Rational y = number(position.items[1], [&] { return "y of " + name(); });
    chain.vertices.push_back({std::move(x), std::move(y)});
    chain.places.push_back(position.at);
  }

  template <typename Name>
  Rational number(const JsonValue& value, Name name) {
    if (value.kind != Kind::number && value.kind != Kind::string)
      input_.refuse(value.at, name() + " is " + describe(value.kind),
                    "a number or a string \"p/q\"");
    return coordinate(input_, value.text, value.at, name);
  }

  const InputText& input_;
  Wanted wanted_;
  PlacedGeometry result_;
};

}  // namespace

PlacedGeometry parse_geojson(const InputText& input, Wanted wanted) {
  return GeoJsonReader(input, wanted).read();
}

}  // namespace oplus
