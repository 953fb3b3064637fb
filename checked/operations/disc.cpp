// SPDX-License-Identifier: MIT
#include "checked/operations/disc.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "reference/arithmetic/floor_of.hpp"
#include "reference/arithmetic/rational_rotation.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

struct GridPoint {
  mpz_class x, y;
};

/// A ring around the origin, in steps of a grid.
struct Ring {
  Rational squared_inner;
  mpz_class squared_outer;  ///< rounded down, as squared lengths of grid points are whole
};

/// Points at angles 0, 1/m, ... of a quarter turn, up to half of it, which is where the octant ends: in the
/// row next to each on the circle of radius √squared_outer, the last one that is not outside.
std::vector<GridPoint> octant(const Ring& ring, const mpz_class& outer, unsigned long m) {
  // So that y is off by less than a half and a bit, wherever it is. Nothing relies on that.
  const auto [cosine, sine] =
      rational_rotation(Rational(90) / m, Rational(1, mpz_class((outer + 1) * m)));
  const mpz_class& denominator = cosine.get_den();
  const std::size_t bits = mpz_sizeinbase(mpz_class(outer * m).get_mpz_t(), 2) + 8;
  const mpz_class one = mpz_class(1) << static_cast<mp_bitcnt_t>(bits);
  std::vector<GridPoint> points;
  mpz_class x = one, y = 0;
  for (unsigned long i = 0; 2 * i <= m; ++i) {
    GridPoint p;
    p.y = 2 * i == m ? sqrt(mpz_class(ring.squared_outer / 2))
                     : floor_of(mpz_class(2 * outer * y + one), mpz_class(2 * one));
    p.x = 2 * i == m ? p.y : sqrt(mpz_class(ring.squared_outer - p.y * p.y));
    if (OPLUS_MUTANT("disc-ends-one-step-further", "vertices of a disc's polygon are beyond it"))
      p.x += 1;
    points.push_back(std::move(p));
    const mpz_class next_x =
        floor_of(mpz_class(x * cosine.get_num() - y * sine.get_num()), denominator);
    y = floor_of(mpz_class(x * sine.get_num() + y * cosine.get_num()), denominator);
    x = next_x;
  }
  return points;
}

/// From the positive x-axis to the positive y-axis.
std::vector<GridPoint> quadrant(std::vector<GridPoint> points, unsigned long m) {
  for (unsigned long i = m / 2 + 1; i <= m; ++i)
    points.push_back({points[m - i].y, points[m - i].x});
  return points;
}

/// Whether a quadrant's edges are outside the ring's hole and it turns left at each vertex, of which those on
/// the axes have the two neighbours that symmetry gives them.
bool is_around_hole(const std::vector<GridPoint>& points, const Ring& ring) {
  const GridPoint before = {points[1].x, -points[1].y};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const GridPoint& a = i == 0 ? before : points[i - 1];
    const GridPoint &b = points[i], &c = points[i + 1];
    const mpz_class x = c.x - b.x, y = c.y - b.y;
    if ((b.x - a.x) * y <= (b.y - a.y) * x) return false;
    const mpz_class across = b.x * c.y - b.y * c.x;
    if (across * across * ring.squared_inner.get_den() <
            ring.squared_inner.get_num() * (x * x + y * y) &&
        !OPLUS_MUTANT("disc-edges-are-not-tested", "edges of a disc's polygon are not tested"))
      return false;
  }
  return true;
}

Chain whole(const std::vector<GridPoint>& quadrant, const Rational& step) {
  Chain chain;
  chain.reserve(4 * (quadrant.size() - 1));
  for (std::size_t i = 0; i + 1 < quadrant.size(); ++i)
    chain.push_back({step * quadrant[i].x, step * quadrant[i].y});
  for (std::size_t i = 0; chain.size() < 4 * (quadrant.size() - 1); ++i)
    chain.push_back({-chain[i].y, chain[i].x});
  return chain;
}

void require_positive(const std::string& name, const Rational& value) {
  if (value <= 0)
    throw InvalidInput({"disc", 0, 0}, "the " + name + (value == 0 ? " is zero" : " is negative"),
                       "a positive one");
}

}  // namespace

Rational short_step(const Rational& x) {
  OPLUS_REQUIRES(x > 0, "short_step");
  Rational step = 1;
  while (step > x) step /= 10;
  while (10 * step <= x) step *= 10;
  for (const int times : {5, 2})
    if (times * step <= x) return times * step;
  return step;
}

bool is_between_discs(const Chain& chain, const Rational& inner, const Rational& outer) {
  int times_around = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Point &a = chain[i], &b = chain[next(i, chain.size())];
    if (squared_length(a) > outer * outer || sign(cross(a, b)) <= 0 ||
        squared_distance({}, {a, b}) < inner * inner ||
        orientation(chain[previous(i, chain.size())], a, b) <= 0)
      return false;
    times_around += a.y < 0 && b.y >= 0;
  }
  return times_around == 1;
}

std::optional<Chain> polygon_between_discs(const Rational& inner, const Rational& outer,
                                           unsigned long most) {
  OPLUS_REQUIRES(0 <= inner && inner < outer, "polygon_between_discs");
  const Rational step = short_step((outer - inner) / 10);
  const Ring ring{inner * inner / (step * step), floor_of(Rational(outer * outer / (step * step)))};
  const mpz_class rounded_outer = sqrt(ring.squared_outer);
  // 4m vertices need an angle of π/4m with cosine c >= inner / outer, and arccos c <= √(1 - c) π/2.
  const mpz_class least = sqrt(floor_of(Rational(outer / (4 * (outer - inner)))));
  for (mpz_class m = std::max(least, mpz_class(1)); 4 * m <= most; m += 1 + m / 100) {
    const unsigned long of_quadrant = m.get_ui();
    const std::vector<GridPoint> points =
        quadrant(octant(ring, rounded_outer, of_quadrant), of_quadrant);
    if (!is_around_hole(points, ring)) continue;
    Chain chain = whole(points, step);
    OPLUS_ENSURES(is_between_discs(chain, inner, outer), "law-disc");
    return chain;
  }
  return std::nullopt;
}

Region disc_polygon(const Rational& radius, DiscSide side, const Rational& error) {
  constexpr unsigned long most_vertices = 1000000;
  require_positive("radius", radius);
  require_positive("error", error);
  std::optional<Chain> chain =
      side == DiscSide::outside
          ? polygon_between_discs(radius, radius + error, most_vertices)
          : polygon_between_discs(error < radius ? Rational(radius - error) : Rational(0), radius,
                                  most_vertices);
  if (!chain)
    throw InvalidInput({"disc", 0, 0},
                       "this error needs more than " + std::to_string(most_vertices) + " vertices",
                       "a larger one");
  return polygon(std::move(*chain));
}

}  // namespace oplus
