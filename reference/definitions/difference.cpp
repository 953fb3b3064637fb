// SPDX-License-Identifier: MIT
#include "reference/definitions/difference.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "reference/definitions/ray.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

/// A sum with its edges at hand.
struct Overlaid {
  explicit Overlaid(const PlanarSet& of) : sum(of), all(edges(of)), features(all) {
    regular.assign(all.begin(), all.end() - static_cast<std::ptrdiff_t>(of.dangling_edges.size()));
    for (const Point& p : of.isolated_vertices) features.push_back({p, p});
  }

  Location locate(const Point& p) const {
    const std::vector<Point>& isolated = sum.isolated_vertices;
    if (lies_on_one(p, all) || std::find(isolated.begin(), isolated.end(), p) != isolated.end())
      return Location::boundary;
    return winding_number(p, regular) + (sum.is_unbounded ? 1 : 0) > 0 ? Location::inside
                                                                       : Location::outside;
  }

  const PlanarSet& sum;
  std::vector<Segment> all;
  std::vector<Segment> features;  ///< and the isolated vertices, as segments
  std::vector<Segment> regular;   ///< without the dangling edges
};

/// A point of the face that `along` enters from `start`.
Point inside_face(const Point& start, const Vector& along, const Overlaid& a, const Overlaid& b) {
  const std::optional<Rational> of_a = first_met(start, along, a.features);
  const std::optional<Rational> of_b = first_met(start, along, b.features);
  if (!of_a && !of_b) return start + along;
  const Rational& first = !of_b || (of_a && *of_a < *of_b) ? *of_a : *of_b;
  return start + Rational(first / 2) * along;
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

/// Segments regardless of direction, to be found among.
class Undirected {
 public:
  explicit Undirected(std::vector<Segment> segments) : sorted_(std::move(segments)) {
    for (Segment& s : sorted_) s = from_smaller_end(std::move(s));
    std::sort(sorted_.begin(), sorted_.end());
  }

  bool contains(const Segment& s) const {
    return std::binary_search(sorted_.begin(), sorted_.end(), from_smaller_end(s));
  }

 private:
  static Segment from_smaller_end(Segment s) {
    if (s.target < s.source) std::swap(s.source, s.target);
    return s;
  }

  std::vector<Segment> sorted_;
};

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

std::optional<Difference> tells_apart(const Point& p, const Overlaid& a, const Overlaid& b) {
  const Location in_a = a.locate(p);
  const Location in_b = b.locate(p);
  if (in_a == in_b) return std::nullopt;
  return Difference{p, in_a, in_b, {}};
}

/// A point of a face beside an edge of a that is in one of the regularized sums only. Where an edge
/// of a is no edge of b, a changes across it and b does not. Where a and b have the same edges as
/// point sets, both change across the same ones and are the same far away: they are equal.
std::optional<Difference> regular_difference(const Overlaid& a, const Overlaid& b) {
  // Where another chain or a dangling edge touches an edge in its middle, the normal would run into
  // it.
  const std::vector<Point> ends = ends_of(a, b);
  const Undirected of_b(b.regular);
  for (const Segment& edge : a.regular) {
    if (of_b.contains(edge)) continue;
    const Vector d = direction_of(edge);
    const Pieces cuts = cut_at(edge, b.regular, ends);
    for (const Segment& piece : cuts.pieces) {
      const Point middle = midpoint(piece.source, piece.target);
      if (lies_on_one(middle, cuts.overlapping)) continue;
      for (const Vector& normal : {Vector{-d.y, d.x}, Vector{d.y, -d.x}}) {
        if (auto found = tells_apart(inside_face(middle, normal, a, b), a, b)) return found;
      }
      if (auto found = tells_apart(middle, a, b)) return found;
    }
  }
  return std::nullopt;
}

std::optional<Difference> dangling_difference(const Overlaid& a, const Overlaid& b) {
  const Undirected of_b(b.all);
  for (const Segment& edge : a.sum.dangling_edges) {
    if (of_b.contains(edge)) continue;
    for (const Segment& piece : cut_at(edge, b.all, b.sum.isolated_vertices).pieces) {
      if (auto found = tells_apart(midpoint(piece.source, piece.target), a, b)) return found;
    }
  }
  return std::nullopt;
}

std::optional<Difference> isolated_difference(const Overlaid& a, const Overlaid& b) {
  std::vector<Point> of_b = b.sum.isolated_vertices;
  std::sort(of_b.begin(), of_b.end());
  for (const Point& p : a.sum.isolated_vertices) {
    if (std::binary_search(of_b.begin(), of_b.end(), p)) continue;
    if (auto found = tells_apart(p, a, b)) return found;
  }
  return std::nullopt;
}

bool in_a_hole(const Point& p, const PlanarSet& sum) {
  return std::any_of(sum.holes.begin(), sum.holes.end(),
                     [&](const Chain& hole) { return winding_number(p, edges(hole)) != 0; });
}

/// A point to the right of all features, where one of the two is unbounded only.
std::optional<Difference> difference_far_away(const Overlaid& a, const Overlaid& b) {
  if (a.sum.is_unbounded == b.sum.is_unbounded) return std::nullopt;
  Point far{0, 0};
  for (const Overlaid* of : {&a, &b})
    for (const Segment& feature : of->features)
      for (const Point& end : {feature.source, feature.target}) far = std::max(far, end);
  return tells_apart(far + Vector{1, 0}, a, b);
}

std::string describe_regular(const Difference& found, const PlanarSet& a, const PlanarSet& b) {
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

Location locate(const Point& p, const PlanarSet& sum) { return Overlaid(sum).locate(p); }

std::optional<Difference> difference(const PlanarSet& a, const PlanarSet& b) {
  if (a == b) return std::nullopt;
  const Overlaid first(a);
  const Overlaid second(b);
  using Look = std::optional<Difference> (*)(const Overlaid&, const Overlaid&);
  const std::pair<Look, std::string> looks[] = {{difference_far_away, ""},
                                                {regular_difference, ""},
                                                {dangling_difference, "a dangling edge"},
                                                {isolated_difference, "an isolated vertex"}};
  for (const auto& [look, feature] : looks) {
    for (const bool turned : {false, true}) {
      std::optional<Difference> found = turned ? look(second, first) : look(first, second);
      if (!found) continue;
      if (turned) std::swap(found->in_a, found->in_b);
      found->what = feature.empty() ? describe_regular(*found, a, b)
                    : turned        ? feature + " of the second is not one of the first"
                                    : feature + " of the first is not one of the second";
      return found;
    }
  }

  const Overlaid& any = first.all.empty() && a.isolated_vertices.empty() ? second : first;
  const Point p = any.all.empty() ? any.sum.isolated_vertices.front() : any.all.front().source;
  return Difference{p, first.locate(p), second.locate(p),
                    "the same points, but one of the two is not in canonical form"};
}

}  // namespace oplus
