// SPDX-License-Identifier: MIT
#include "checked/layouts/builder.hpp"
#include "reference/io/unchecked_input.hpp"

namespace oplus::layouts {

void read_polygons(Builder& builder, const std::string& text) {
  PlacedGeometry all = read_unchecked(text, builder.input.name).geometry;
  for (auto chain = all.chains.begin(); chain != all.chains.end();) {
    const std::size_t number = chain->name.component, line = chain->places.at(0).line;
    PlacedGeometry polygon;
    for (; chain != all.chains.end() && chain->name.component == number; ++chain) {
      polygon.chains.push_back(std::move(*chain));
      polygon.chains.back().name.component = 1;
    }
    polygon.beyond_the_plane = std::exchange(all.beyond_the_plane, 0);
    Region region = naming("part " + std::to_string(number),
                           [&] { return builder.region(std::move(polygon)); });
    builder.place("", line, nullptr, std::move(region), {});
  }
}

}  // namespace oplus::layouts
