// SPDX-License-Identifier: MIT
// Input: numbers of any kind, points of any type, files; all checked.
#include <fstream>
#include <iostream>
#include <oplus/oplus.hpp>

struct Corner {  // your own type: members x and y, or two elements
  double x, y;
};

int main() {
  // Integers, doubles, GMP's rationals and text, each taken for exactly what it is.
  oplus::Number tenth("0.1"), near_tenth(0.1), third(oplus::Rational(1, 3));
  std::cout << tenth.value() << ' ' << third.value() << ' '
            << (tenth.value() == near_tenth.value() ? "equal" : "0.1 is not a tenth") << '\n';
  oplus::Coordinates point(third, "1e-2");
  std::cout << point.point().x << ' ' << point.point().y << '\n';

  // Any range of points; the second list holds the holes.
  auto triangle = oplus::polygon(std::vector<Corner>{{0, 0}, {4, 0}, {0, 4}});
  auto framed = oplus::polygon({{0, 0}, {9, 0}, {9, "9.5"}, {0, 9}}, {{{1, 1}, {2, 1}, {1, 2}}});
  std::cout << to_wkt(triangle) << '\n' << to_wkt(framed) << '\n';

  // Several components, of text, of a file, or put together.
  auto geojson =
      oplus::read_geojson(R"({"type":"Polygon","coordinates":[[[5,0],[6,0],[5,1],[5,0]]]})");
  std::ofstream("islands.wkt") << "MULTIPOLYGON(((0 0,1 0,0 1,0 0)),((3 0,4 0,3 1,3 0)))";
  auto islands = oplus::read_file("islands.wkt");
  oplus::Region both = islands.region();
  both.components.push_back(geojson.components()[0]);
  std::cout << oplus::ValidRegion(both).components().size() << " components\n";

  // Any format that oplus reads (docs/files.md); polygons that overlap, as their union.
  std::cout << to_wkt(oplus::read_text("M 0 0 H 4 V 4 H 0 Z")) << '\n'
            << to_wkt(oplus::read_text("[[[[0,0],[2,0],[2,2],[0,2]]], [[[1,0],[3,0],[3,2],[1,2]]]]",
                                       oplus::Overlaps::allowed))
            << '\n';

  // What is invalid is refused, in one line.
  try {
    oplus::polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  } catch (const oplus::InvalidInput& error) {
    std::cout << error.what() << '\n';
  }
  try {
    oplus::read_wkt("POLYGON((0 0,1 0,\n0 one))");
  } catch (const oplus::InvalidInput& error) {
    std::cout << error.what() << "\nline " << error.where().line << '\n';
  }

  // Or mended, where that is asked for; each thing that was done is said.
  std::ofstream("drawn.wkt") << "POLYGON((0 0,4 0,4 0,\n4 4,0 4))";
  oplus::Repaired mended = oplus::repaired_file("drawn.wkt");
  for (const oplus::Mend& mend : mended.mends)
    std::cout << mend.where.line << ':' << mend.where.column << ": " << mend.what << '\n';
  std::cout << to_wkt(mended.region) << '\n';
  oplus::Region bow_tie{{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}}};
  auto filled = oplus::repaired(bow_tie, oplus::FillRule::even_odd);
  std::cout << filled.mends[0].what << '\n' << to_wkt(filled.region) << '\n';
  std::cout << oplus::repaired_text("M0 0H9V9H0Z").mends.size() << " to mend\n";
}
