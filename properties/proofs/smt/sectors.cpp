// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/sectors.hpp"

#include "reference/definitions/cyclic_order.hpp"

namespace oplus::smt {

Vectors direction(const Values& values, const std::string& name) {
  return [values, name] { return values.direction(name); };
}

Vectors opposite(const Vectors& v) {
  return [v] { return -v(); };
}

Vectors sum(const Vectors& u, const Vectors& v) {
  return [u, v] { return u() + v(); };
}

Vectors leftwards(const Vectors& v) {
  return [v]() -> TermVector {
    const TermVector along = v();
    const int up = sign(along.y);
    if (up != 0) return {-up, 0};
    return {0, sign(along.x)};
  };
}

Formula is_left(const Vectors& of, const Vectors& d) {
  return executed([&] { return cross(of(), d()) > 0; });
}

Formula is_right(const Vectors& of, const Vectors& d) {
  return executed([&] { return cross(of(), d()) < 0; });
}

Formula are_equal(const Vectors& u, const Vectors& v) {
  return executed([&] { return cyclic_order::compare_angle(u(), v()) == 0; });
}

Formula are_parallel(const Vectors& u, const Vectors& v) {
  return executed([&] { return cross(u(), v()) == 0; });
}

Formula is_in_tangent_set(const Vectors& d, Summand of, const Corners& corner) {
  return executed([&] {
    return cyclic_order::in_tangent_set(TermDirection{d(), of},
                                        TermCorner{corner.in(), corner.out()});
  });
}

Formula is_a_reflex_vertex(const Corners& corner) {
  return executed([&] { return cyclic_order::is_reflex(TermCorner{corner.in(), corner.out()}); });
}

Formula is_in_sector(const Vectors& d, const Corners& corner) {
  return executed([&] {
    return cyclic_order::counterclockwise_between(TermDirection{d(), Summand::P},
                                                  TermDirection{corner.out(), Summand::P},
                                                  TermDirection{-corner.in(), Summand::P});
  });
}

Formula turns_back(const Corners& corner) { return are_equal(corner.out, opposite(corner.in)); }

Formula one_is_in(const std::vector<Vectors>& candidates,
                  const std::function<Formula(const Vectors&)>& is_in_both) {
  std::vector<Formula> any;
  for (const Vectors& candidate : candidates) any.push_back(is_in_both(candidate));
  return any_of(any);
}

}  // namespace oplus::smt
