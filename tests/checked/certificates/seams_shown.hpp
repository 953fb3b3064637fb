// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <string>

#include "checked/certificates/certificate.hpp"
#include "reference/definitions/segment.hpp"
#include "reference/io/writing.hpp"

namespace oplus::certificates {

/// What the seams of a certificate show, by their definition and with exact numbers only: cells are cut again, and
/// each point and interval is looked at.
class ShownSeams {
 public:
  /// Of the open set only dangling edges and isolated vertices are looked at.
  ShownSeams(const Certificate& certificate, const ClaimedSum& open_set)
      : certificate_(certificate), open_set_(open_set) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, const Seam*> given;
    for (const auto& [from, to, seam] : certificate.diagonals) given[{from, to}] = &seam;
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> sides;
    const Seam unwritten;
    for (std::size_t i = 0; i < certificate.sum.pieces.size(); ++i) {
      Chain corners;
      for (const std::uint32_t corner : certificate.sum.pieces[i])
        corners.push_back(certificate.sum.vertices[corner]);
      std::size_t step = 0;
      const PieceSums::Pair first = walk(certificate.trees[i], step, corners);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::uint32_t from = certificate.sum.pieces[i][k];
        const std::uint32_t to = certificate.sum.pieces[i][next(k, corners.size())];
        sides[{from, to}] = true;
        if (!sides.contains({to, from})) continue;
        const auto own = given.find({from, to});
        look_at(own == given.end() ? unwritten : *own->second, first, corners[k],
                corners[next(k, corners.size())]);
        if (own != given.end()) given.erase(own);
      }
    }
    if (!given.empty()) fault = "a seam of what is no diagonal";
  }

  std::string fault;  ///< empty: each seam holds
  std::size_t seams = 0, usual = 0, points_in_sums = 0, on_edges = 0, at_vertices = 0;

 private:
  using Pair = PieceSums::Pair;

  /// Returns the first leaf.
  Pair walk(const Tree& tree, std::size_t& step, const Chain& cell) {
    const Step& here = tree[step++];
    if (const auto* pair = std::get_if<Pair>(&here)) {
      for (const Point& corner : cell)
        if (least_above(*pair, corner) < 0) fault = to_string(corner) + " is outside of its leaf";
      return *pair;
    }
    const Cut& cut = std::get<Cut>(here);
    const IntegerLine& line = cut.line;
    const auto height = [&](const Point& x) {
      return Rational(line.a * x.x + line.b * x.y + line.c);
    };
    Chain positive, negative, ends;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Point &x = cell[k], &y = cell[next(k, cell.size())];
      const Rational of_x = height(x), of_y = height(y);
      if (of_x >= 0) positive.push_back(x);
      if (of_x <= 0) negative.push_back(x);
      if (of_x == 0) ends.push_back(x);
      if (of_x * of_y >= 0) continue;
      const Point crossing = x + of_x / (of_x - of_y) * (y - x);
      for (Chain* part : {&positive, &negative, &ends}) part->push_back(crossing);
    }
    const Pair of_positive = walk(tree, step, positive);
    const Pair of_negative = walk(tree, step, negative);
    if (ends.size() != 2) {
      fault = "a cut with " + std::to_string(ends.size()) + " ends";
      return of_positive;
    }
    // In the direction (b, -a).
    const Point across = ends[1] - ends[0];
    if (line.b * across.x - line.a * across.y < 0) std::swap(ends[0], ends[1]);
    look_at(cut.seam, of_negative, ends[0], ends[1]);
    return of_positive;
  }

  void look_at(const Seam& seam, const Pair& first_leaf, const Point& from, const Point& to) {
    ++seams;
    if (seam.is_usual()) {
      ++usual;
      return look_at(Seam::Place(first_leaf), from, to);
    }
    if (seam.intervals.size() != seam.points.size() + 1) fault = "too many intervals or too few";
    Point start = from;
    for (std::size_t i = 0; i < seam.intervals.size(); ++i) {
      const Point end = i == seam.points.size() ? to : point(seam.points[i], from, to);
      if (!lies_on(end, {start, to}) || end == start || (end == to) != (i == seam.points.size()))
        fault = to_string(end) + " is not behind " + to_string(start) + " on a seam";
      look_at(seam.intervals[i], start, end);
      start = end;
    }
  }

  void look_at(const Seam::Place& interval, const Point& from, const Point& to) {
    if (const auto* pair = std::get_if<Pair>(&interval)) {
      if (least_above(*pair, from) < 0 || least_above(*pair, to) < 0 ||
          least_above(*pair, midpoint(from, to)) <= 0)
        fault = "from " + to_string(from) + " to " + to_string(to) + " is not in a sum of pieces";
    } else {
      ++on_edges;
      const Segment& edge = open_set_.dangling_edges.at(std::get<DanglingEdge>(interval).number);
      if (!lies_on(from, edge) || !lies_on(to, edge))
        fault = "from " + to_string(from) + " to " + to_string(to) + " is not on an edge";
    }
  }

  /// Also looks at it.
  Point point(const Seam::Point& given, const Point& from, const Point& to) {
    if (const auto* vertex = std::get_if<IsolatedVertex>(&given.place)) {
      ++at_vertices;
      return open_set_.isolated_vertices.at(vertex->number);
    }
    const Vector along = to - from;
    const bool by_x = abs(along.y) <= abs(along.x);
    const Rational t = by_x ? Rational((given.coordinate - from.x) / along.x)
                            : Rational((given.coordinate - from.y) / along.y);
    const Point x = from + t * along;
    if (const auto* pair = std::get_if<Pair>(&given.place)) {
      ++points_in_sums;
      if (least_above(*pair, x) <= 0) fault = to_string(x) + " is not inside a sum of pieces";
    } else if (!lies_on(x,
                        open_set_.dangling_edges.at(std::get<DanglingEdge>(given.place).number))) {
      fault = to_string(x) + " is not on an edge";
    }
    return x;
  }

  /// How far a point is above the nearest side of T ⊕ U, times the side's length; below 0 outside of it.
  Rational least_above(const Pair& pair, const Point& x) const {
    const Chain t = corners(certificate_.p.pieces, pair.i),
                u = corners(certificate_.q.pieces, pair.j);
    std::optional<Rational> least;
    for (const Chain* piece : {&t, &u}) {
      for (const Segment& side : edges(*piece)) {
        const auto height = [&](const Point& v) {
          return Rational((side.source.y - side.target.y) * v.x +
                          (side.target.x - side.source.x) * v.y);
        };
        const auto lowest = [&](const Chain& of) {
          Rational low = height(of[0]);
          for (const Point& v : of) low = std::min(low, height(v));
          return low;
        };
        const Rational above = height(x) - lowest(t) - lowest(u);
        if (!least || above < *least) least = above;
      }
    }
    return *least;
  }

  static Chain corners(const ConvexPieces& pieces, std::uint32_t piece) {
    Chain result;
    for (const std::uint32_t corner : pieces.pieces.at(piece))
      result.push_back(pieces.vertices[corner]);
    return result;
  }

  const Certificate& certificate_;
  const ClaimedSum& open_set_;
};

}  // namespace oplus::certificates
