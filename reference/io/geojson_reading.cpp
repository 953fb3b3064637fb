// SPDX-License-Identifier: MIT
#include <optional>
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
    const JsonTree tree(input_);
    geometry(tree.root(), wanted_ == Wanted::sum);
    return std::move(result_);
  }

 private:
  void geometry(JsonValue value, bool may_be_collection) {
    require(value, Kind::object, "a geometry");
    const JsonValue type_value = member(value, "type");
    require(type_value, Kind::string, "the type of a geometry");
    const std::string type(type_value.text());
    const bool sum = wanted_ == Wanted::sum;
    if (type == "Polygon") {
      const JsonValue rings = coordinates(value, type);
      if (rings.begin() != rings.end()) polygon(rings);
    } else if (type == "MultiPolygon") {
      for (const JsonValue rings : coordinates(value, type)) polygon(rings);
    } else if (sum && type == "LineString") {
      line_string(coordinates(value, type));
    } else if (sum && type == "MultiLineString") {
      for (const JsonValue line : coordinates(value, type)) line_string(line);
    } else if (sum && type == "Point") {
      point(coordinates(value, type));
    } else if (sum && type == "MultiPoint") {
      for (const JsonValue position : coordinates(value, type)) point(position);
    } else if (may_be_collection && type == "GeometryCollection") {
      const JsonValue geometries = member(value, "geometries");
      require(geometries, Kind::array, "'geometries' of a GeometryCollection");
      for (const JsonValue of_collection : geometries) geometry(of_collection, false);
    } else {
      input_.refuse(type_value.at(), "the type " + quote(type),
                    !sum                ? "Polygon or MultiPolygon"
                    : may_be_collection ? "(Multi)Polygon, (Multi)LineString, (Multi)Point or "
                                          "GeometryCollection"
                                        : "(Multi)Polygon, (Multi)LineString or (Multi)Point");
    }
  }

  JsonValue member(JsonValue object, const std::string& key) {
    const std::optional<JsonValue> found = object.member(key);
    if (!found) input_.refuse(object.at(), "an object without " + quote(key), "a GeoJSON geometry");
    return *found;
  }

  JsonValue coordinates(JsonValue geometry, const std::string& type) {
    const JsonValue value = member(geometry, "coordinates");
    require(value, Kind::array, "'coordinates' of a " + type);
    return value;
  }

  void require(JsonValue value, Kind kind, const std::string& what) {
    if (value.kind() != kind)
      input_.refuse(value.at(), what + " is " + describe(value.kind()), describe(kind));
  }

  void polygon(JsonValue rings) {
    ChainName name{result_.next_component(), 0};
    require(rings, Kind::array, "component " + std::to_string(name.component));
    if (rings.begin() == rings.end())
      input_.refuse(rings.at(), "component " + std::to_string(name.component) + " has no chain",
                    "an outer chain");
    for (const JsonValue item : rings) {
      result_.chains.push_back(ring(item, name));
      ++name.hole;
    }
  }

  PlacedChain ring(JsonValue positions, const ChainName& name) {
    PlacedChain chain = vertices_of(positions, describe(name));
    chain.name = name;
    remove_closing_vertex(input_, chain);
    return chain;
  }

  void line_string(JsonValue positions) {
    const std::string number = std::to_string(result_.line_strings.size() + 1);
    result_.line_strings.push_back(vertices_of(positions, "line string " + number));
  }

  void point(JsonValue position) {
    const std::string number = std::to_string(result_.points.vertices.size() + 1);
    add_vertex(result_.points, position, [&] { return "point " + number; });
  }

  PlacedChain vertices_of(JsonValue positions, const std::string& name) {
    require(positions, Kind::array, name);
    PlacedChain chain{.start = positions.at()};
    const std::size_t count = positions.size();
    chain.vertices.reserve(count);
    chain.places.reserve(count);
    for (const JsonValue position : positions)
      add_vertex(chain, position, [&] {
        return "vertex " + std::to_string(chain.places.size() + 1) + " of " + name;
      });
    return chain;
  }

  template <typename Name>
  void add_vertex(PlacedChain& chain, JsonValue position, Name name) {
    const Position place = position.at();
    if (position.kind() != Kind::array)
      input_.refuse(place, name() + " is " + describe(position.kind()), "an array [x, y]");
    if (position.size() != 2)
      input_.refuse(place, name() + " has " + counted(position.size(), "coordinate", "coordinates"),
                    "an array [x, y]");
    JsonValue::Iterator coordinate = position.begin();
    Point& vertex = chain.vertices.emplace_back();
    put_number(vertex.x, *coordinate, [&] { return "x of " + name(); });
    put_number(vertex.y, *++coordinate, [&] { return "y of " + name(); });
    chain.places.push_back(place);
  }

  template <typename Name>
  void put_number(Rational& number, JsonValue value, Name name) {
    if (value.kind() != Kind::number && value.kind() != Kind::string)
      input_.refuse(value.at(), name() + " is " + describe(value.kind()),
                    "a number or a string \"p/q\"");
    put_coordinate(input_, value.text(), value.at(), number, name);
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
