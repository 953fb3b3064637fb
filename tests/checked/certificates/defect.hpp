// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "checked/certificates/certificate.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus::certificates {

/// What is wrong with a certificate, by the rules of docs/certificates.md, all pairs tried; else empty.
class Defect {
 public:
  Defect(const Region& p, const Region& q, const Region& s, const Certificate& certificate)
      : certificate_(certificate) {
    if (sgn(certificate.unit) <= 0) say("the unit is not positive");
    check_pieces("p", p, certificate.p.pieces);
    check_pieces("q", q, certificate.q.pieces);
    check_pieces("s", s, certificate.sum);
    if (!text_.empty()) return;
    const auto p_roots = roots(certificate.p), q_roots = roots(certificate.q);
    check_separation(s, p_roots, q_roots);
    if (certificate.trees.size() != certificate.sum.pieces.size()) {
      say("trees are missing");
      return;
    }
    for (std::size_t i = 0; i < certificate.trees.size(); ++i) {
      auto step = certificate.trees[i].begin();
      check_tree(polygon_of(certificate.sum, i), step, certificate.trees[i].end());
      if (step != certificate.trees[i].end()) say("a tree goes on after its end");
    }
  }

  const std::string& text() const { return text_; }

 private:
  void say(const std::string& what) {
    if (text_.empty()) text_ = what;
  }

  static std::vector<Point> vertices(const ConvexPieces& pieces) {
    std::vector<Point> all = pieces.vertices;
    for (const pieces::PointInEdge& point : pieces.points) all.push_back(point.point);
    return all;
  }

  static Chain polygon_of(const ConvexPieces& pieces, std::size_t i) {
    const std::vector<Point> all = vertices(pieces);
    Chain corners;
    for (const std::uint32_t corner : pieces.pieces[i]) corners.push_back(all.at(corner));
    return corners;
  }

  static bool has_fan_from(const Chain& corners, std::size_t first) {
    const auto at = [&](std::size_t k) -> const Point& {
      return corners[(first + k) % corners.size()];
    };
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      if (orientation(at(0), at(k), at(k + 1)) <= 0) return false;
    return corners.size() >= 3;
  }

  void check_pieces(const std::string& name, const Region& region, const ConvexPieces& pieces) {
    std::map<Segment, int> balance;
    std::uint32_t number = 0;
    auto point = pieces.points.begin();
    for (const Chain& chain : chains(region)) {
      for (const Segment& e : edges(chain)) {
        Point from = e.source;
        for (; point != pieces.points.end() && point->edge == number; ++point) {
          if (!lies_on(point->point, {from, e.target}) || point->point == from)
            say("a point is not in its edge of " + name);
          --balance[{from, point->point}];
          from = point->point;
        }
        --balance[{from, e.target}];
        if (pieces.vertices.at(number) != e.source) say("another vertex of " + name);
        ++number;
      }
    }
    if (point != pieces.points.end()) say("points of " + name + " are not in the order of edges");
    for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
      const Chain corners = polygon_of(pieces, i);
      if (!has_fan_from(corners, 0)) say("a piece of " + name + " has no fan");
      for (const Segment& e : edges(corners)) {
        ++balance[e];
        for (const Point& corner : corners)
          if (orientation(e.source, e.target, corner) < 0) say("a piece is not convex");
      }
    }
    for (const auto& [edge, count] : balance) {
      const auto back = balance.find({edge.target, edge.source});
      if (count != (back == balance.end() ? 0 : back->second))
        say("the pieces of " + name + " have other edges than it");
    }
  }

  std::vector<std::size_t> roots(const Certificate::PiecesOfSummand& summand) {
    std::set<std::uint32_t> targets;
    for (const auto& link : summand.links) targets.insert(link.next);
    std::vector<std::size_t> roots;
    std::set<std::uint32_t> reached;
    for (std::uint32_t i = 0; i < summand.pieces.pieces.size(); ++i) {
      if (targets.contains(i)) continue;
      roots.push_back(i);
      reached.insert(i);
    }
    for (const auto& link : summand.links) {
      const Chain from = polygon_of(summand.pieces, link.reached);
      const Chain to = polygon_of(summand.pieces, link.next);
      if (!reached.contains(link.reached)) say("a link from a piece that is not reached");
      if (std::ranges::find_first_of(from, to) == from.end()) say("a link without common corner");
      if (!reached.insert(link.next).second) say("a link to a piece that is reached");
    }
    return roots;
  }

  /// Whether a line along one of the directions has the segment on one side, the sum on the other.
  static bool are_apart(const Segment& e, const Chain& t, const Chain& u) {
    std::vector<Segment> directions = {e};
    for (const Chain* chain : {&t, &u})
      for (const Segment& side : edges(*chain)) directions.push_back(side);
    return std::ranges::any_of(directions, [&](const Segment& line) {
      const Vector along = direction_of(line);
      const auto range = [&](const Chain& points) {
        std::set<Rational> heights;
        for (const Point& p : points) heights.insert(cross(along, p));
        return std::pair(*heights.begin(), *heights.rbegin());
      };
      const auto [e_low, e_high] = range({e.source, e.target});
      const auto [t_low, t_high] = range(t);
      const auto [u_low, u_high] = range(u);
      return e_high <= t_low + u_low || e_low >= t_high + u_high;
    });
  }

  void check_separation(const Region& s, const std::vector<std::size_t>& p_roots,
                        const std::vector<std::size_t>& q_roots) {
    const std::vector<Segment> all = edges(s);
    for (std::size_t i = 0; i < certificate_.p.pieces.pieces.size(); ++i) {
      for (std::size_t j = 0; j < certificate_.q.pieces.pieces.size(); ++j) {
        const Chain t = polygon_of(certificate_.p.pieces, i);
        const Chain u = polygon_of(certificate_.q.pieces, j);
        for (const Segment& e : all)
          if (!are_apart(e, t, u)) say("an edge of S meets a sum of pieces");
        if (std::ranges::find(p_roots, i) == p_roots.end() ||
            std::ranges::find(q_roots, j) == q_roots.end())
          continue;
        const auto inner = [](const Chain& c) {
          return Point{(c[0].x + c[1].x + c[2].x) / 3, (c[0].y + c[1].y + c[2].y) / 3};
        };
        if (winding_number(inner(t) + inner(u), all) == 0) say("a root is outside S");
      }
    }
  }

  static Rational value(const IntegerLine& line, const Point& p, int sign) {
    return (Rational(line.a) * p.x + Rational(line.b) * p.y + Rational(line.c)) * sign;
  }

  static Chain clipped(const Chain& polygon, const IntegerLine& line, int sign) {
    Chain result;
    for (const Segment& e : edges(polygon)) {
      const Rational at_source = value(line, e.source, sign);
      const Rational at_target = value(line, e.target, sign);
      if (at_source >= 0) result.push_back(e.source);
      if (sgn(at_source) * sgn(at_target) < 0) {
        const Rational t = at_source / (at_source - at_target);
        result.push_back({e.source.x + t * (e.target.x - e.source.x),
                          e.source.y + t * (e.target.y - e.source.y)});
      }
    }
    return result;
  }

  static bool is_sum(const Point& x, const Chain& t, const Chain& u) {
    for (const auto& [of, other] : {std::pair(&t, &u), std::pair(&u, &t)}) {
      for (const Segment& side : edges(*of)) {
        const Vector along = direction_of(side);
        if (std::ranges::all_of(*other, [&](const Point& corner) {
              return cross(along, x - side.source - corner) < 0;
            }))
          return false;
      }
    }
    return true;
  }

  void check_tree(const Chain& cell, Tree::const_iterator& step, Tree::const_iterator end) {
    if (step == end) return say("a tree ends early");
    if (const auto* cut = std::get_if<IntegerLine>(&*step)) {
      ++step;
      check_tree(clipped(cell, *cut, 1), step, end);
      check_tree(clipped(cell, *cut, -1), step, end);
      return;
    }
    const auto& [i, j] = std::get<PieceSums::Pair>(*step++);
    bool has_fan = false;
    for (std::size_t k = 0; k < cell.size(); ++k) has_fan = has_fan || has_fan_from(cell, k);
    if (!has_fan) say("a cell has no fan");
    const Chain t = polygon_of(certificate_.p.pieces, i), u = polygon_of(certificate_.q.pieces, j);
    for (const Point& corner : cell)
      if (!is_sum(corner, t, u)) say("a cell is not in its sum of pieces");
  }

  const Certificate& certificate_;
  std::string text_;
};

}  // namespace oplus::certificates
