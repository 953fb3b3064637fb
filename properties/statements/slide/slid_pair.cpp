// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/slide/slid_pair.hpp"

#include <algorithm>

#include "checked/slide/place_inside.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/contract.hpp"

namespace oplus {

SlidPair::SlidPair(const Summands& pair)
    : summands(pair),
      scaling(slide::scaling_of(slide::extent_of(pair.p, slide::Denominators::any),
                                slide::extent_of(pair.q, slide::Denominators::any))),
      segments(pair.p, pair.q, scaling),
      minus_q_(reflected(pair.q)) {
  OPLUS_REQUIRES(scaling.bits <= Numbers::bits, "coordinates of 29 bits");
  segments.prepare_boxes();
}

Point SlidPair::point(std::uint32_t segment, const Place& t) const {
  return slide::ExactPoint<Numbers>(segments[segment].exact, t).in_the_plane(scaling);
}

Vector SlidPair::direction(std::uint32_t segment) const {
  const auto& d = segments.direction(segment);
  return {Rational(d.x), Rational(d.y)};
}

Point SlidPair::shifted(std::uint32_t segment, const Place& t) const {
  // Places have denominators of less than 64 bits and coordinates less than 30 bits, so that a skew
  // product that is not zero is larger than 2^-200.
  static const Rational little = [] {
    mpz_class large;
    mpz_ui_pow_ui(large.get_mpz_t(), 2, 500);
    return Rational(1, large);
  }();
  const Vector d = direction(segment);
  return point(segment, t) + little * Vector{d.y, -d.x};
}

bool SlidPair::interiors_meet_at(const Point& x) const {
  return interiors_meet(summands.p, translated(minus_q_, x));
}

std::vector<SlidPair::Place> SlidPair::between(std::vector<Place> places) const {
  std::erase_if(places, [](const Place& t) { return !(Place{0, 1} < t) || !(t < Place{1, 1}); });
  places.push_back({0, 1});
  places.push_back({1, 1});
  std::sort(places.begin(), places.end());
  std::vector<Place> inside;
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i - 1] < places[i])
      inside.push_back(slide::place_inside(Piece{places[i - 1], places[i]}));
  return inside;
}

slide::ShortList<slide::FreePiece<SlidPair::Numbers>> SlidPair::free_pieces() const {
  slide::FreePieces<Numbers> search(segments.summands());
  slide::ShortList<slide::FreePiece<Numbers>> pieces;
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    search.find(segments[i], [&](Piece piece) { pieces.push_back({i, std::move(piece)}); });
  return pieces;
}

}  // namespace oplus
