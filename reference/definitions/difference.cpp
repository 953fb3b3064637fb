// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/difference.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

/// A sum with its edges at hand.
struct Overlaid {
  explicit Overlaid(const MinkowskiSum& of) : sum(of), all(edges(of)) {
    regular.assign(all.begin(), all.end() - static_cast<std::ptrdiff_t>(of.dangling_edges.size()));
  }

  Location locate(const Point& p) const {
    const bool on_edge =
        std::any_of(all.begin(), all.end(), [&](const Segment& e) { return lies_on(p, e); });
    const std::vector<Point>& isolated = sum.isolated_vertices;
    if (on_edge || std::find(isolated.begin(), isolated.end(), p) != isolated.end())
      return Location::boundary;
    return winding_number(p, regular) > 0 ? Location::inside : Location::outside;
  }

  const MinkowskiSum& sum;
  std::vector<Segment> all;
  std::vector<Segment> regular;  ///< without the dangling edges
};

/// The least t > 0 at which start + t·along meets a feature of the sum, if it is less than `first`.
void meet(const Point& start, const Vector& along, const Overlaid& a,
          std::optional<Rational>& first) {
  const auto at = [&](const Rational& t) {
    if (sign(t) > 0 && (!first || t < *first)) first = t;
  };
  const auto at_point = [&](const Point& p) {
    if (cross(along, p - start) == 0) at(dot(along, p - start) / dot(along, along));
  };
  for (const Segment& e : a.all) {
    const Vector d = direction_of(e);
    const Rational turn = cross(along, d);
    if (turn == 0) {
      at_point(e.source);
      at_point(e.target);
      continue;
    }
    const Rational along_edge = cross(e.source - start, along) / turn;
    if (sign(along_edge) >= 0 && along_edge <= 1) at(cross(e.source - start, d) / turn);
  }
  for (const Point& p : a.sum.isolated_vertices) at_point(p);
}

/// A point of the face that `along` enters from `start`.
Point inside_face(const Point& start, const Vector& along, const Overlaid& a, const Overlaid& b) {
  std::optional<Rational> first;
  meet(start, along, a, first);
  meet(start, along, b, first);
  return start + (first ? Rational(*first / 2) : Rational(1)) * along;
}

/// The edge of a and where it meets edges of b: its pieces are wholly on b's boundary or off it.
struct Pieces {
  std::vector<Segment> pieces;
  std::vector<Segment> overlapping;  ///< edges of b that run along it
};

Pieces cut_at(const Segment& edge, const std::vector<Segment>& of_b, std::vector<Point> contacts) {
  Pieces result;
  for (const Segment& e : of_b) {
    const std::vector<Point> common = intersection(edge, e);
    contacts.insert(contacts.end(), common.begin(), common.end());
    if (common.size() == 2) result.overlapping.push_back(e);
  }
  result.pieces = cut(edge, std::move(contacts));
  return result;
}

std::vector<Point> ends_of(const Overlaid& a, const Overlaid& b) {
  std::vector<Point> ends;
  for (const Overlaid* of : {&a, &b}) {
    for (const Segment& e : of->all) {
      ends.push_back(e.source);
      ends.push_back(e.target);
    }
  }
  return ends;
}

struct Found {
  Point witness;
  Location in_a;
  Location in_b;
};

std::optional<Found> tells_apart(const Point& p, const Overlaid& a, const Overlaid& b) {
  const Location in_a = a.locate(p);
  const Location in_b = b.locate(p);
  if (in_a == in_b) return std::nullopt;
  return Found{p, in_a, in_b};
}

/// A point of a face beside an edge of a that is in one of the regularized sums only. Where an edge
/// of a is no edge of b, a changes across it and b does not. Where a and b have the same edges as
/// point sets, both change across the same ones and are outside far away: they are equal.
std::optional<Found> regular_difference(const Overlaid& a, const Overlaid& b) {
  // Where another chain or a dangling edge touches an edge in its middle, the normal would run into
  // it.
  const std::vector<Point> ends = ends_of(a, b);
  for (const Segment& edge : a.regular) {
    const Vector d = direction_of(edge);
    const Pieces cuts = cut_at(edge, b.regular, ends);
    for (const Segment& piece : cuts.pieces) {
      const Point middle = midpoint(piece.source, piece.target);
      const bool shared = std::any_of(cuts.overlapping.begin(), cuts.overlapping.end(),
                                      [&](const Segment& e) { return lies_on(middle, e); });
      if (shared) continue;
      for (const Vector& normal : {Vector{-d.y, d.x}, Vector{d.y, -d.x}}) {
        if (auto found = tells_apart(inside_face(middle, normal, a, b), a, b)) return found;
      }
      if (auto found = tells_apart(middle, a, b)) return found;
    }
  }
  return std::nullopt;
}

std::optional<Found> dangling_difference(const Overlaid& a, const Overlaid& b) {
  for (const Segment& edge : a.sum.dangling_edges) {
    for (const Segment& piece : cut_at(edge, b.all, b.sum.isolated_vertices).pieces) {
      if (auto found = tells_apart(midpoint(piece.source, piece.target), a, b)) return found;
    }
  }
  return std::nullopt;
}

std::optional<Found> isolated_difference(const Overlaid& a, const Overlaid& b) {
  for (const Point& p : a.sum.isolated_vertices) {
    if (auto found = tells_apart(p, a, b)) return found;
  }
  return std::nullopt;
}

std::optional<Found> swapped(std::optional<Found> found) {
  if (found) std::swap(found->in_a, found->in_b);
  return found;
}

bool in_a_hole(const Point& p, const MinkowskiSum& sum) {
  return std::any_of(sum.holes.begin(), sum.holes.end(),
                     [&](const Chain& hole) { return winding_number(p, edges(hole)) != 0; });
}

std::string describe_regular(const Found& found, const MinkowskiSum& a, const MinkowskiSum& b) {
  const bool more_in_first = found.in_a == Location::inside || found.in_b == Location::outside;
  const std::string more = more_in_first ? "the first" : "the second";
  const std::string less = more_in_first ? "the second" : "the first";
  if (found.in_a == Location::boundary || found.in_b == Location::boundary)
    return "an edge of " +
           (found.in_a == Location::boundary ? std::string("the first")
                                             : std::string("the second")) +
           " has the same on both sides";
  if (in_a_hole(found.witness, more_in_first ? b : a))
    return "a hole of " + less + " is filled, wholly or in part, in " + more;
  return more + " covers a place outside " + less;
}

}  // namespace

Location locate(const Point& p, const MinkowskiSum& sum) { return Overlaid(sum).locate(p); }

std::optional<Difference> difference(const MinkowskiSum& a, const MinkowskiSum& b) {
  if (a == b) return std::nullopt;
  const Overlaid first(a);
  const Overlaid second(b);
  const auto explained = [](const Found& found, std::string what) {
    return Difference{found.witness, found.in_a, found.in_b, std::move(what)};
  };

  auto found = regular_difference(first, second);
  if (!found) found = swapped(regular_difference(second, first));
  if (found) return explained(*found, describe_regular(*found, a, b));

  if ((found = dangling_difference(first, second)))
    return explained(*found, "a dangling edge of the first is none in the second");
  if ((found = swapped(dangling_difference(second, first))))
    return explained(*found, "a dangling edge of the second is none in the first");
  if ((found = isolated_difference(first, second)))
    return explained(*found, "an isolated vertex of the first is none in the second");
  if ((found = swapped(isolated_difference(second, first))))
    return explained(*found, "an isolated vertex of the second is none in the first");

  const Overlaid& any = first.all.empty() && a.isolated_vertices.empty() ? second : first;
  const Point p = any.all.empty() ? any.sum.isolated_vertices.front() : any.all.front().source;
  return Difference{p, first.locate(p), second.locate(p),
                    "the same points, but one of the two is not in canonical form"};
}

}  // namespace oplus
