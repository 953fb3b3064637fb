// SPDX-License-Identifier: MIT
#include "checked/certificates/piece_sums.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "reference/io/writing.hpp"

namespace oplus::certificates {

namespace {

/// b - a but for a positive factor, as near as doubles. It has a size of its own: the coordinates may be larger
/// than it by more than all doubles.
Place direction(const Point& a, const Point& b) {
  const auto is_short = [](const Rational& x) {
    return x.get_den() == 1 && mpz_sizeinbase(x.get_num_mpz_t(), 2) <= 52;
  };
  if (is_short(a.x) && is_short(a.y) && is_short(b.x) && is_short(b.y))
    return {b.x.get_num().get_d() - a.x.get_num().get_d(),
            b.y.get_num().get_d() - a.y.get_num().get_d()};
  const Point exact{b.x - a.x, b.y - a.y};
  return ShiftedDoubles(std::span(&exact, 1)).near(exact);
}

double along(const HalfPlane& side, const Place& p) { return side.a * p.x + side.b * p.y; }

double lowest(const HalfPlane& side, const std::vector<Place>& corners) {
  double low = std::numeric_limits<double>::infinity();
  for (const Place& corner : corners) low = std::min(low, along(side, corner));
  return low;
}

}  // namespace

NearPieces::NearPieces(const ConvexPieces& pieces, const ShiftedDoubles& doubles) : exact(pieces) {
  std::vector<Place> places;
  for (const Point& p : exact.vertices) places.push_back(doubles.near(p));
  std::vector<Box> boxes_around;
  for (const ConvexPiece& piece : exact.pieces) {
    auto& [corners, sides] = near.emplace_back();
    Box& box = boxes_around.emplace_back();
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const Point& a = exact.vertices[piece[k]];
      const Point& b = exact.vertices[piece[next(k, piece.size())]];
      const Place& place = corners.emplace_back(places[piece[k]]);
      box = around(box, {place.x, place.y, place.x, place.y});
      const auto [dx, dy] = direction(a, b);
      const double length = std::hypot(dx, dy);
      HalfPlane& side = sides.emplace_back(HalfPlane{-dy / length, dx / length, 0});
      side.low = along(side, place);
    }
  }
  boxes = BoxTree<>(boxes_around);
}

PointOutsideSum::PointOutsideSum(const Point& x)
    : std::logic_error(to_string(x) + " is in no sum of two pieces") {}

std::vector<PieceSums::Pair> PieceSums::pairs_around(const Place& x, std::size_t most) const {
  std::vector<Pair> pairs;
  std::size_t tested = 0;
  for_each_box_around(x, error_, [&](const Pair& pair) {
    if (is_near(pair, x)) pairs.push_back(pair);
    return ++tested < most;
  });
  if (tested < most) return pairs;
  // One more for each of a few pieces from all over P.
  constexpr std::size_t enough = 16;
  const std::size_t size = p_.near.size();
  std::size_t stride = size * 5 / 8;
  while (std::gcd(stride, size) != 1) ++stride;
  for (std::size_t k = 0; k < size && (k < enough || pairs.empty()); ++k) {
    BoxTree<>::Range piece = p_.boxes.all();
    while (!piece.is_leaf()) {
      const auto [first, second] = piece.halves();
      piece = k * stride % size < first.end ? first : second;
    }
    visit(x, error_, piece, q_.boxes.all(), [&](const Pair& pair) {
      if (!is_near(pair, x)) return true;
      pairs.push_back(pair);
      return false;
    });
  }
  return pairs;
}

bool PieceSums::is_near(const Pair& pair, const Place& x) const {
  const NearPiece &t = p_.near[pair.i], &u = q_.near[pair.j];
  for (const auto& [of, other] : {std::pair(&t, &u), std::pair(&u, &t)})
    for (const HalfPlane& side : of->sides)
      if (side.above(x) - lowest(side, other->corners) < -error_) return false;
  return true;
}

void PieceSums::sides(const Pair& pair, std::vector<HalfPlane>& result) const {
  const NearPiece &t = p_.near[pair.i], &u = q_.near[pair.j];
  result.clear();
  for (const auto& [of, other] : {std::pair(&t, &u), std::pair(&u, &t)})
    for (const HalfPlane& side : of->sides)
      result.push_back({side.a, side.b, side.low + lowest(side, other->corners)});
}

const IntegerLine& PieceSums::exact_side(const Pair& pair, std::size_t side) {
  auto& lines = exact_sides_[(std::uint64_t{pair.i} << 32) + pair.j];
  lines.resize(p_.near[pair.i].sides.size() + q_.near[pair.j].sides.size());
  auto& [is_known, line] = lines[side];
  if (!is_known) line = computed_side(pair, side);
  is_known = true;
  return line;
}

int PieceSums::side_of(const Pair& pair, std::size_t side, const HalfPlane& half_plane,
                       const CellCorner& corner) {
  const double above = half_plane.above(corner.near);
  return above > error_    ? 1
         : above < -error_ ? -1
                           : certificates::side_of(exact_side(pair, side), corner.exact);
}

IntegerLine PieceSums::computed_side(const Pair& pair, std::size_t side) const {
  const ConvexPiece *of = &p_.exact.pieces[pair.i], *other = &q_.exact.pieces[pair.j];
  const std::vector<Point>*vertices = &p_.exact.vertices, *others = &q_.exact.vertices;
  if (side >= of->size()) {
    side -= of->size();
    std::swap(of, other);
    std::swap(vertices, others);
  }
  const Point& source = (*vertices)[(*of)[side]];
  const Point& target = (*vertices)[(*of)[next(side, of->size())]];
  const Vector normal{source.y - target.y, target.x - source.x};
  std::optional<Rational> low;
  Rational here;
  for (const std::uint32_t corner : *other) {
    const Point& p = (*others)[corner];
    here = normal.x * p.x + normal.y * p.y;
    if (!low || here < *low) low = here;
  }
  const Rational c = -(*low + normal.x * source.x + normal.y * source.y);
  const mpz_class scale = lcm(lcm(normal.x.get_den(), normal.y.get_den()), c.get_den());
  const auto whole = [&](const Rational& x) {
    return mpz_class(x.get_num() * (scale / x.get_den()));
  };
  IntegerLine line{whole(normal.x), whole(normal.y), whole(c)};
  divide_by_common_factor(line.a, line.b, line.c);
  return line;
}

}  // namespace oplus::certificates
