// SPDX-License-Identifier: GPL-3.0-or-later
// x(t) = c + t d runs along a segment; from c all sources are taken off, so that the edge of P is u, from
// the origin, that of Q is w, and their sum the parallelogram of u and w. In the coordinates a and b of
// x = a u + b w, it is the unit square; they keep or mirror orientation, so that there are two cases, u =
// (1, 0), w = (0, 1) and the other way round. Slide's code sees these vectors only through skew products,
// which are all multiplied by the same number, and through the sign of the scalar product of two that
// are parallel, which stays. So what it returns in these coordinates, it returns in all.
#include "properties/proofs/smt/queries/slid_edges.hpp"
#include "properties/proofs/smt/query.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus::smt {

namespace {

using slide::Shift;

/// Whether the strip of the coordinate `at`, whose unit vector is `inwards` at 0, has x, shifted to the
/// right of d, which is parallel to the strip.
Formula is_in_strip_when_shifted(const Term& at, const TermVector& d, const TermVector& inwards) {
  const auto is_on_the_right = [&](const TermVector& v) {
    return Formula::sign_of(cross(d, v), {.negative = true});
  };
  return any_of({is_inside_unit(at),
                 all_of({Formula::sign_of(at, {.zero = true}), is_on_the_right(inwards)}),
                 all_of({Formula::sign_of(at - 1, {.zero = true}), is_on_the_right(-inwards)})});
}

const std::vector<Unknown> line_and_place = {any_vector("c"), any_vector("d"), any_number("t")};

TermVector place(const Values& values) {
  return values.vector("c") + values.number("t") * values.vector("d");
}

Formula is_not_zero(const Term& term) {
  return Formula::sign_of(term, {.negative = true, .positive = true});
}

Formula are_equal(const TermVector& v, const TermVector& w) {
  return all_of({is_zero(v.x - w.x), is_zero(v.y - w.y)});
}

Formula is_inside_unit_square(const TermVector& x) {
  return all_of({is_inside_unit(x.x), is_inside_unit(x.y)});
}

SlidEdges edges_of(const Values& values, const Sides& sides) {
  return {values.vector("c"), values.vector("d"), sides.u, sides.w};
}

/// Whether they cross properly a little after t or a little before.
bool cross_beside(const SlidEdges& edges, const Rational& t, const Rational& little, Shift shift) {
  const auto at = [&](const Rational& place) { return edges.c + Term(place) * edges.d; };
  return cross_at(edges, at(t + little), shift) || cross_at(edges, at(t - little), shift);
}

/// d goes one to the right, or to the left, in the first coordinate: how fast x(t) runs does not matter,
/// step-interval.pace.
Query across(const Sides& sides, int way) {
  const auto edges = [sides, way](const Values& values) -> SlidEdges {
    return {values.vector("c"), {way, values.number("rise")}, sides.u, sides.w};
  };
  return {
      .id = "step-interval.across" + std::string(way > 0 ? "" : "-back") + sides.suffix,
      .unknowns = {any_vector("c"), any_number("rise"), any_number("t")},
      .hypotheses = {{"across",
                      {"d, which is (" + std::to_string(way) +
                           ", rise), is parallel to neither edge",
                       [](const Values& values) { return is_not_zero(values.number("rise")); }}}},
      .conclusion = {"t is in the interval of the code iff x(t) is inside the parallelogram",
                     [edges](const Values& values) {
                       const Term t = values.number("t");
                       const TermVector x = edges(values).c + t * edges(values).d;
                       return same(blocks(edges(values), t), is_inside_unit_square(x));
                     }},
      .is_false_by_definition = [edges](const Model& model) {
        const Values values(model);
        const Term t = values.number("t");
        return blocks_in_integers(edges(values), t) !=
               cross_at(edges(values), edges(values).c + t * edges(values).d, Shift::none);
      }};
}

/// k d instead of d, k t instead of t, where d is in the quadrant of (x, y).
Query pace(const Sides& sides, int x, int y) {
  return {
      .id = std::string("step-interval.pace") + (x > 0 ? "-right" : "-left") +
            (y > 0 ? "-up" : "-down") + sides.suffix,
      .unknowns = {any_vector("c"), any_vector("d"), any_number("k"), any_number("t")},
      .hypotheses = {{"positive",
                      {"k > 0",
                       [](const Values& values) { return is_positive(values.number("k")); }},
                      {{"d is (" + std::to_string(x) + ", " + std::to_string(y) + ")",
                        [x, y](const Values& values) {
                          return are_equal(values.vector("d"), {x, y});
                        }}}}},
      .conclusion = {"t is in the interval for k d iff k t is in that for d",
                     [sides](const Values& values) {
                       const TermVector c = values.vector("c"), d = values.vector("d");
                       const Term k = values.number("k"), t = values.number("t");
                       return same(blocks({c, k * d, sides.u, sides.w}, t),
                                   blocks({c, d, sides.u, sides.w}, k * t));
                     }},
      .in_case = {{"d is in the quadrant of (" + std::to_string(x) + ", " + std::to_string(y) + ")",
                   [x, y](const Values& values) {
                     const TermVector d = values.vector("d");
                     return all_of({is_positive(x * d.x), is_positive(y * d.y)});
                   }}},
      .is_false_by_definition = [sides](const Model& model) {
        const Values values(model);
        const TermVector c = values.vector("c"), d = values.vector("d");
        const Term k = values.number("k"), t = values.number("t");
        return blocks_in_integers({c, k * d, sides.u, sides.w}, t) !=
               blocks_in_integers({c, d, sides.u, sides.w}, k * t);
      }};
}

bool is_along_p(const Sides& sides, bool is_upright) { return is_upright != sides.suffix.empty(); }

/// d is parallel to (0, 1) or to (1, 0).
Condition is_along_side(const Sides& sides, bool is_upright) {
  return {
      std::string("d is parallel to the edge of ") + (is_along_p(sides, is_upright) ? "P" : "Q"),
      [is_upright](const Values& values) {
        const TermVector d = values.vector("d");
        return is_zero(is_upright ? d.x : d.y);
      }};
}

/// Along a side, with the shift.

Query along(const Sides& sides, bool is_upright) {
  const auto shifted = [is_upright](const Values& values) {
    const TermVector x = place(values), d = values.vector("d");
    return is_upright ? all_of({is_in_strip_when_shifted(x.x, d, {1, 0}), is_inside_unit(x.y)})
                      : all_of({is_in_strip_when_shifted(x.y, d, {0, 1}), is_inside_unit(x.x)});
  };

  return {
      .id = std::string("step-interval.along-") + (is_along_p(sides, is_upright) ? "p" : "q") +
            sides.suffix,
      .unknowns = line_and_place,
      .hypotheses = {{"along",
                      is_along_side(sides, is_upright),
                      {{is_upright ? "d is (1, 1), t is 1/2, and x(t) is (0, 1/2)"
                                   : "d is (-1, -1), t is 1/2, and x(t) is (1/2, 0)",
                        [is_upright](const Values& values) {
                          const TermVector d = values.vector("d"), x = place(values);
                          const Rational half(1, 2);
                          const int way = is_upright ? 1 : -1;
                          return all_of({is_zero(d.x - way), is_zero(d.y - way),
                                         is_zero(values.number("t") - half),
                                         is_zero(x.x - (is_upright ? Rational(0) : half)),
                                         is_zero(x.y - (is_upright ? half : Rational(0)))});
                        }}}},
                     {"moves",
                      {"d is not zero",
                       [is_upright](const Values& values) {
                         const TermVector d = values.vector("d");
                         return is_not_zero(is_upright ? d.y : d.x);
                       }}}},
      .conclusion = {"t is in the interval of the code iff x(t) is between the other two sides, "
                     "and inside the parallelogram or on a side with the inside to the right",
                     [sides, shifted](const Values& values) {
                       return same(blocks(edges_of(values, sides), values.number("t")),
                                   shifted(values));
                     }},
      .is_false_by_definition = [sides, shifted](const Model& model) {
        const Values values(model);
        return blocks_in_integers(edges_of(values, sides), values.number("t")) !=
               shifted(values).value().value();
      }};
}

/// On such a line, without the shift: what open sums ask for.
Query unshifted(const Sides& sides, bool is_upright) {
  const auto edges = [sides](const Values& values) {
    SlidEdges all = edges_of(values, sides);
    all.shift = Shift::none;
    return all;
  };
  return {.id = std::string("step-candidates.along-") +
                (is_along_p(sides, is_upright) ? "p" : "q") + sides.suffix,
          .unknowns = line_and_place,
          .hypotheses = {{"moves",
                          {"d is not zero",
                           [](const Values& values) {
                             const TermVector d = values.vector("d");
                             return any_of({is_not_zero(d.x), is_not_zero(d.y)});
                           }},
                          {{"t is 0",
                            [](const Values& values) { return is_zero(values.number("t")); }}}}},
          .conclusion = {"without the shift, t is in the interval of the code iff x(t) is inside "
                         "the parallelogram",
                         [edges](const Values& values) {
                           return same(blocks(edges(values), values.number("t")),
                                       is_inside_unit_square(place(values)));
                         }},
          .in_case = {is_along_side(sides, is_upright)},
          .is_false_by_definition = [edges](const Model& model) {
            const Values values(model);
            return blocks_in_integers(edges(values), values.number("t")) !=
                   cross_at(edges(values), place(values), Shift::none);
          }};
}

/// One of the four, as flags of c: that is 0 or 1 in each coordinate.
Query corner(const Sides& sides) {
  return {.id = "step-interval.corner" + sides.suffix,
          .unknowns = {any_vector("c"), any_vector("d")},
          .hypotheses =
              {{"corner",
                {"c is a corner of the parallelogram",
                 [](const Values& values) {
                   const TermVector c = values.vector("c");
                   return all_of({any_of({is_zero(c.x), is_zero(c.x - 1)}),
                                  any_of({is_zero(c.y), is_zero(c.y - 1)})});
                 }},
                {{"c is inside the parallelogram",
                  [](const Values& values) { return is_inside_unit_square(values.vector("c")); }}}},
               {"passes",
                {"neither d nor its opposite points into the parallelogram from there, or along a "
                 "side",
                 executed([](const Values& values) {
                   const TermVector c = values.vector("c"), d = values.vector("d");
                   const int to_x = c.x == 0 ? 1 : -1, to_y = c.y == 0 ? 1 : -1;
                   return sign(d.x) * to_x * sign(d.y) * to_y < 0;
                 })}}},
          .conclusion = {"the code finds no interval",
                         [sides](const Values& values) {
                           return negation(blocks_somewhere(edges_of(values, sides)));
                         }},
          .is_false_by_definition = [sides](const Model& model) {
            const Values values(model);
            // Where the line enters, it is inside on one side of the corner.
            const SlidEdges edges = edges_of(values, sides);
            const Rational little(1, 1'000'000'007);
            const Rational most =
                abs(edges.d.x.value().value()) + abs(edges.d.y.value().value()) + 1;
            return cross_beside(edges, 0, little / most, Shift::to_the_right);
          }};
}

/// By orientations, as the definition of a proper crossing has it.
Formula cross_properly_by_orientations(const TermVector& a, const TermVector& b,
                                       const TermVector& c, const TermVector& d) {
  const auto turns = [](const TermVector& p, const TermVector& q, const TermVector& r, int how) {
    return Formula::sign_of(cross(q - p, r - p), {.negative = how<0, .positive = how> 0});
  };
  const auto are_parted = [&](const TermVector& p, const TermVector& q, const TermVector& r,
                              const TermVector& s) {
    return any_of({all_of({turns(p, q, r, 1), turns(p, q, s, -1)}),
                   all_of({turns(p, q, r, -1), turns(p, q, s, 1)})});
  };
  return all_of({are_parted(a, b, c, d), are_parted(c, d, a, b)});
}

bool is_model_crossing(const Model& model) {
  const Vector u = vector_in(model, "u"), w = vector_in(model, "w"), x = vector_in(model, "x");
  return cross_properly({{0, 0}, u}, {x, x - w});
}

/// In any coordinates: 0 < [x, w] < area and 0 < [u, x] < area, or all mirrored.
Formula is_in_parallelogram(const TermVector& u, const TermVector& w, const TermVector& x,
                            int how) {
  const Signs expected{.negative = how<0, .positive = how> 0};
  std::vector<Formula> parts;
  for (const Term& value :
       {cross(x, w), cross(u, w) - cross(x, w), cross(u, x), cross(u, w) - cross(u, x)})
    parts.push_back(Formula::sign_of(value, expected));
  return all_of(parts);
}

const Query crossing = {
    .id = "step-interval.crossing",
    .unknowns = {any_vector("u"), any_vector("w"), any_vector("x")},
    .hypotheses =
        {{"inside",
          {"x is inside the parallelogram of u and w",
           [](const Values& values) {
             const TermVector u = values.vector("u"), w = values.vector("w"),
                              x = values.vector("x");
             return any_of({is_in_parallelogram(u, w, x, 1), is_in_parallelogram(u, w, x, -1)});
           }},
          {{"u is (2, 1), and w is (1, 3)",
            [](const Values& values) {
              const TermVector u = values.vector("u"), w = values.vector("w");
              return all_of(
                  {is_zero(u.x - 2), is_zero(u.y - 1), is_zero(w.x - 1), is_zero(w.y - 3)});
            }}}}},
    .conclusion = {"the segments from 0 to u and from x to x - w cross properly",
                   [](const Values& values) {
                     const TermVector x = values.vector("x");
                     return cross_properly_by_orientations({0, 0}, values.vector("u"), x,
                                                           x - values.vector("w"));
                   }},
    .is_false_by_definition = std::not_fn(is_model_crossing)};

Query only_crossing() {
  Query query = crossing;
  query.id = "step-interval.only-crossing";
  query.hypotheses = {{"crossing", crossing.conclusion, crossing.hypotheses[0].of_twin}};
  query.conclusion = crossing.hypotheses[0].condition;
  return query;
}

/// The two edges at the vertex that touches the segment's own edge. General vectors: nothing is
/// normalised.
Query own_edge(Summand edge_of, bool leaves) {
  const std::string name = std::string(edge_of == Summand::P ? "p" : "q") +
                           (leaves ? "-touched-before" : "-touched-behind");
  // The vertex's edge from its source, seen from the segment's source, which is its vertex.
  const auto edges = [edge_of, leaves](const Values& values) {
    const TermVector d = values.vector("d"), side = values.vector("side");
    const TermVector c = leaves ? TermVector{0, 0} : side;
    return edge_of == Summand::P ? SlidEdges{c, d, d, side} : SlidEdges{c, d, side, d};
  };
  return {.id = "step-interval.own-edge-of-" + name,
          .unknowns = {any_vector("d"), any_vector("side")},
          .hypotheses = {{"kept",
                          {std::string("the edge at the vertex, seen from there, does not point ") +
                               "to the right of d, as at each segment of the reduced convolution",
                           [leaves](const Values& values) {
                             const Term turn = cross(values.vector("d"), values.vector("side"));
                             return Formula::sign_of(leaves ? turn : -turn,
                                                     {.zero = true, .positive = true});
                           }},
                          {{"d is (2, 1)",
                            [](const Values& values) {
                              return are_equal(values.vector("d"), {2, 1});
                            }}}}},
          .conclusion = {"the code finds no interval for the segment's own edge and that one",
                         [edges](const Values& values) {
                           return negation(blocks_somewhere(edges(values)));
                         }},
          .is_false_by_definition = [edges](const Model& model) {
            const Values values(model);
            const SlidEdges own = edges(values);
            return cross_at(own, own.c + Term(Rational(1, 2)) * own.d, Shift::to_the_right);
          }};
}

const Query parallel = {
    .id = "step-interval.parallel",
    .unknowns = {any_vector("c"), any_vector("d"), any_vector("u"), any_vector("w")},
    .hypotheses = {{"parallel",
                    {"u and w are parallel",
                     [](const Values& values) {
                       return is_zero(cross(values.vector("u"), values.vector("w")));
                     }},
                    {{"c is (0, -1), d is (1, 2), u is (1, 0), and w is (0, w.y)",
                      [](const Values& values) {
                        const TermVector c = values.vector("c"), d = values.vector("d"),
                                         u = values.vector("u"), w = values.vector("w");
                        return all_of({is_zero(c.x), is_zero(c.y + 1), is_zero(d.x - 1),
                                       is_zero(d.y - 2), is_zero(u.x - 1), is_zero(u.y),
                                       is_zero(w.x)});
                      }}}}},
    .conclusion = {"the code finds no interval",
                   [](const Values& values) {
                     return negation(blocks_somewhere({values.vector("c"), values.vector("d"),
                                                       values.vector("u"), values.vector("w")}));
                   }},
    .is_false_by_definition = [](const Model& model) {
      const Values values(model);
      const SlidEdges edges{values.vector("c"), values.vector("d"), values.vector("u"),
                            values.vector("w")};
      // The line enters the parallelogram at t = 1/2, or leaves it there.
      return cross_beside(edges, {1, 2}, {1, 1'000'000'007}, Shift::none);
    }};

/// The sign of a + k b, for small k > 0: that of a, or of b where a is zero.
const Query shift = {
    .id = "step-interval.shift",
    .unknowns = {any_number("a"), any_number("b"), any_number("k")},
    .hypotheses =
        {{"positive",
          {"k > 0", [](const Values& values) { return is_positive(values.number("k")); }}},
         {"small",
          {"a is zero, or k b is smaller than a in size", executed([](const Values& values) {
             const Term a = values.number("a");
             const Term by = values.number("k") * values.number("b");
             if (a == 0) return true;
             return a > 0 ? -a < by && by < a : a < by && by < -a;
           })},
          {{"k = 1", [](const Values& values) { return is_zero(values.number("k") - 1); }}}}},
    .conclusion = {"a + k b has the sign of a, or, where a is zero, that of b",
                   executed([](const Values& values) {
                     const Term a = values.number("a"), b = values.number("b");
                     const Term shifted = a + values.number("k") * b;
                     return sign(shifted) == (a == 0 ? sign(b) : sign(a));
                   })},
    .is_false_by_definition = [](const Model& model) {
      const Rational &a = model.numbers.at("a"), &b = model.numbers.at("b");
      const Rational shifted = a + model.numbers.at("k") * b;
      return oplus::sign(shifted) != oplus::sign(oplus::sign(a) == 0 ? b : a);
    }};

const Sides straight{"", {1, 0}, {0, 1}};
const Sides mirrored{"-mirrored", {0, 1}, {1, 0}};

std::vector<Query> all_queries() {
  std::vector<Query> all = {crossing, only_crossing(), parallel, shift};
  for (const Sides& sides : {straight, mirrored}) {
    for (const int x : {1, -1}) all.push_back(across(sides, x));
    for (const int x : {1, -1})
      for (const int y : {1, -1}) all.push_back(pace(sides, x, y));
    for (const bool is_upright : {true, false}) {
      all.push_back(along(sides, is_upright));
      all.push_back(unshifted(sides, is_upright));
    }

    all.push_back(corner(sides));
  }
  for (const Summand of : {Summand::P, Summand::Q})
    for (const bool leaves : {true, false}) all.push_back(own_edge(of, leaves));
  return all;
}

const RegisteredQueries registered(all_queries());

}  // namespace

}  // namespace oplus::smt
