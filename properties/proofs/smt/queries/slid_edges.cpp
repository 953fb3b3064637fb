// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/queries/slid_edges.hpp"

#include "properties/proofs/smt/symbolic_numbers.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus::smt {

namespace {

std::optional<slide::BlockedInterval<SymbolicNumbers>> interval(const SlidEdges& edges) {
  const slide::IntegerVector<SymbolicNumbers> origin{0, 0};
  return slide::blocked_interval<SymbolicNumbers>({slide_vector(edges.c), slide_vector(edges.d)},
                                                  {origin, slide_vector(edges.u)},
                                                  {origin, slide_vector(edges.w)}, edges.shift);
}

Vector known(const TermVector& v) { return {v.x.value().value(), v.y.value().value()}; }

using Integers = slide::AnyNumbers;
using Integer = Integers::Value;

Integer integer(const mpz_class& value) { return Integer(value.get_str()); }

}  // namespace

Formula is_inside_unit(const Term& value) {
  return all_of({Formula::sign_of(value, {.positive = true}),
                 Formula::sign_of(value - 1, {.negative = true})});
}

Formula blocks(const SlidEdges& edges, const Term& t) {
  return executed([&] {
    const auto blocked = interval(edges);
    const slide::Fraction<SymbolicNumbers> place(t, 1);
    return blocked && blocked->from < place && place < blocked->to;
  });
}

Formula blocks_somewhere(const SlidEdges& edges) {
  return executed([&] { return interval(edges).has_value(); });
}

bool blocks_in_integers(const SlidEdges& edges, const Term& t) {
  mpz_class scale = 1;
  for (const TermVector& v : {edges.c, edges.d, edges.u, edges.w})
    scale = lcm(scale, lcm(v.x.value()->get_den(), v.y.value()->get_den()));
  const auto scaled = [&](const TermVector& v) -> slide::IntegerVector<Integers> {
    const Vector at = Rational(scale) * known(v);
    return {integer(at.x.get_num()), integer(at.y.get_num())};
  };
  const slide::IntegerVector<Integers> origin{0, 0};
  const auto blocked = slide::blocked_interval<Integers>({scaled(edges.c), scaled(edges.d)},
                                                         {origin, scaled(edges.u)},
                                                         {origin, scaled(edges.w)}, edges.shift);
  const Rational at = t.value().value();
  const slide::Fraction<Integers> place(integer(at.get_num()), integer(at.get_den()));
  return blocked && blocked->from < place && place < blocked->to;
}

bool cross_at(const SlidEdges& edges, const TermVector& x, slide::Shift shift) {
  const Vector d = known(edges.d);
  const Rational little(1, mpz_class("1000000000000000000000"));
  const Rational by = shift == slide::Shift::none ? Rational(0) : little;
  const Point at = known(x) + by * Vector{d.y, -d.x};
  return cross_properly({{0, 0}, known(edges.u)}, {at, at - known(edges.w)});
}

}  // namespace oplus::smt
