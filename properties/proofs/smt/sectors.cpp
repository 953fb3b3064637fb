// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/sectors.hpp"

#include "reference/definitions/cyclic_order.hpp"

namespace oplus::smt {

Vectors direction(const std::string& name) {
  return [name](const Values& values) { return values.direction(name); };
}

Vectors opposite(const Vectors& v) {
  return [v](const Values& values) { return -v(values); };
}

Vectors sum(const Vectors& u, const Vectors& v) {
  return [u, v](const Values& values) { return u(values) + v(values); };
}

Vectors leftwards(const Vectors& v) {
  return [v](const Values& values) -> TermVector {
    const TermVector along = v(values);
    const int up = sign(along.y);
    if (up != 0) return {-up, 0};
    return {0, sign(along.x)};
  };
}

Corners corner(const std::string& prefix) {
  return {direction(prefix + "in"), direction(prefix + "out")};
}

Corner corner_in(const Model& model, const std::string& prefix) {
  return {direction_in(model, prefix + "in"), direction_in(model, prefix + "out")};
}

Claim is_left(const Vectors& of, const Vectors& d) {
  return executed([of, d](const Values& values) { return cross(of(values), d(values)) > 0; });
}

Claim is_right(const Vectors& of, const Vectors& d) {
  return executed([of, d](const Values& values) { return cross(of(values), d(values)) < 0; });
}

Claim are_equal(const Vectors& u, const Vectors& v) {
  return executed([u, v](const Values& values) {
    return cyclic_order::compare_angle(u(values), v(values)) == 0;
  });
}

Claim are_parallel(const Vectors& u, const Vectors& v) {
  return executed([u, v](const Values& values) { return cross(u(values), v(values)) == 0; });
}

Claim is_in_tangent_set(const Vectors& d, Summand of, const Corners& corner) {
  return executed([d, of, corner](const Values& values) {
    return cyclic_order::in_tangent_set(TermDirection{d(values), of},
                                        TermCorner{corner.in(values), corner.out(values)});
  });
}

Claim is_a_reflex_vertex(const Corners& corner) {
  return executed([corner](const Values& values) {
    return cyclic_order::is_reflex(TermCorner{corner.in(values), corner.out(values)});
  });
}

Claim is_in_sector(const Vectors& d, const Corners& corner) {
  return executed([d, corner](const Values& values) {
    return cyclic_order::counterclockwise_between(TermDirection{d(values), Summand::P},
                                                  TermDirection{corner.out(values), Summand::P},
                                                  TermDirection{-corner.in(values), Summand::P});
  });
}

Claim turns_back(const Corners& corner) { return are_equal(corner.out, opposite(corner.in)); }

Claim one_is_in(const std::vector<Vectors>& candidates,
                const std::function<Claim(const Vectors&)>& is_in_both) {
  std::vector<Claim> any;
  for (const Vectors& candidate : candidates) any.push_back(is_in_both(candidate));
  return any_of(any);
}

}  // namespace oplus::smt
