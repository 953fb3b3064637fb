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
    TextPlace place;
    do {
      const JsonTree tree(input_, place);
      add(tree.root());
    } while (place.at != input_.text.size());
    return std::move(result_);
  }

  PlacedGeometry read(JsonValue value) {
    add(value);
    return std::move(result_);
  }

 private:
  void add(JsonValue value) {
    if (value.kind() == Kind::array)
      arrays(value);
    else
      geometry(value, anything);
  }

  /// What may be where: each of these also what comes before it.
  enum Allowed { simple, collection, anything };

  /// Reads coordinates alone, of a ring, a polygon or several, told apart by their depth.
  void arrays(JsonValue value) {
    rings_may_be_open_ = true;
    std::size_t depth = 0;
    std::optional<JsonValue> first = value;
    for (; first->kind() == Kind::array; first = *first->begin()) {
      ++depth;
      if (first->begin() == first->end()) break;
    }
    if (value.begin() == value.end()) return;
    if (depth == 3) return polygon(value);
    if (depth == 4) {
      for (const JsonValue rings : value) polygon(rings);
      return;
    }
    if (depth != 2)
      input_.refuse(value.at(), "an array of depth " + std::to_string(depth),
                    "[[x, y], ...], an array of these (the first one the outer chain, the others "
                    "holes), or an array of such arrays");
    result_.chains.push_back(ring(value, {}));
  }

  void geometry(JsonValue value, Allowed allowed) {
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
    } else if (allowed >= collection && type == "GeometryCollection") {
      for (const JsonValue part : parts(value, "geometries", type)) geometry(part, simple);
    } else if (allowed == anything && type == "Feature") {
      feature(value);
    } else if (allowed == anything && type == "FeatureCollection") {
      for (const JsonValue part : parts(value, "features", type)) feature(part);
    } else {
      input_.refuse(type_value.at(), "the type " + quote(type), expected(allowed));
    }
  }

  std::string expected(Allowed allowed) const {
    const bool sum = wanted_ == Wanted::sum;
    const std::string and_before = allowed == simple ? " or " : ", ";
    return (sum ? "(Multi)Polygon, (Multi)LineString" + and_before + "(Multi)Point"
                : "Polygon" + and_before + "MultiPolygon") +
           (allowed == simple       ? ""
            : allowed == collection ? " or GeometryCollection"
                                    : ", GeometryCollection, Feature or FeatureCollection");
  }

  JsonValue parts(JsonValue value, const std::string& key, const std::string& type) {
    const JsonValue all = member(value, key);
    require(all, Kind::array, "'" + key + "' of a " + type);
    return all;
  }

  /// A feature without a geometry, which is null then, contributes nothing.
  void feature(JsonValue value) {
    require(value, Kind::object, "a feature");
    const JsonValue type = member(value, "type");
    if (type.kind() != Kind::string || type.text() != "Feature")
      input_.refuse(type.at(), "a feature of another type", "Feature");
    const JsonValue of_feature = member(value, "geometry");
    if (of_feature.kind() != Kind::null) geometry(of_feature, collection);
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
    if (chain.vertices.empty()) refuse_too_few_vertices(input_, chain.start, name, 0);
    remove_closing_vertex(chain);
    if (rings_may_be_open_) chain.is_open = false;
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
    const std::size_t dimension = position.size();
    if (dimension < 2 || dimension > 4)
      input_.refuse(place, name() + " has " + counted(dimension, "coordinate", "coordinates"),
                    "an array [x, y]");
    if (dimension > 2) ++result_.beyond_the_plane;
    JsonValue::Iterator coordinate = position.begin();
    Point& vertex = chain.vertices.emplace_back();
    put_number(vertex.x, *coordinate, [&] { return "x of " + name(); });
    put_number(vertex.y, *++coordinate, [&] { return "y of " + name(); });
    for (++coordinate; coordinate != position.end(); ++coordinate) {
      Rational left_out;
      put_number(left_out, *coordinate, [&] { return "a coordinate beyond x and y of " + name(); });
    }
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
  bool rings_may_be_open_ = false;  ///< whether the last vertex need not be the first one again
};

}  // namespace

PlacedGeometry parse_geojson(const InputText& input, Wanted wanted) {
  return GeoJsonReader(input, wanted).read();
}

PlacedGeometry parse_geojson(const InputText& input, JsonValue value) {
  return GeoJsonReader(input, Wanted::region).read(value);
}

}  // namespace oplus
