// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries of P and of -Q, placed, have a point in common. Around it the interiors are sectors: of a
// vertex that of its corner, of a point inside an edge the half disk to its left.
#include <algorithm>
#include <array>

#include "checked/collision/contact.hpp"
#include "properties/proofs/smt/built_regions.hpp"
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/cyclic_order.hpp"

namespace oplus::smt {

namespace {

/// The rays of both boundaries: along the edge that leaves, back along the one that enters.
struct Ray {
  std::string edge;
  bool is_reverse;
  Summand of;
};
const std::array<Ray, 4> rays = {{{"p.out", false, Summand::P},
                                  {"p.in", true, Summand::P},
                                  {"q.out", false, Summand::Q},
                                  {"q.in", true, Summand::Q}}};

Vectors vector_of(const Values& values, const Ray& ray) {
  const Vectors edge = direction(values, ray.edge);
  return ray.is_reverse ? opposite(edge) : edge;
}

/// Places around the point, of which neighbours are different; rays with the same place are equal.
using Order = std::array<std::size_t, 4>;

/// The order in which the rays come by their angles from the positive x-axis: every one, ties included.
std::vector<Order> orders() {
  std::vector<Order> all;
  for (std::size_t code = 0; code < 256; ++code) {
    const Order order = {code % 4, code / 4 % 4, code / 16 % 4, code / 64};
    const std::size_t last = *std::max_element(order.begin(), order.end());
    bool has_gap = false;
    for (std::size_t place = 0; place < last; ++place)
      has_gap = has_gap || std::find(order.begin(), order.end(), place) == order.end();
    if (!has_gap) all.push_back(order);
  }
  return all;
}

/// What the collision tests conclude from the order alone, by the code that they run.
bool interiors_are_said_to_meet(const Order& order) {
  std::vector<InteriorSides> sides(1 + *std::max_element(order.begin(), order.end()));
  for (std::size_t i = 0; i < rays.size(); ++i)
    sides[order[i]][static_cast<std::size_t>(rays[i].of)] = !rays[i].is_reverse;
  return is_sector_inside_both(sides);
}

Formula are_in_order(const Values& values, const Order& order) {
  std::vector<Formula> parts;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vectors u = vector_of(values, rays[i]), v = vector_of(values, rays[j]);
      const int expected = order[i] < order[j] ? -1 : order[i] > order[j] ? 1 : 0;
      parts.push_back(executed([&] {
        const int compared = cyclic_order::compare_angle(u(), v());
        return (compared > 0) - (compared < 0) == expected;
      }));
    }
  }
  return all_of(parts);
}

Formula are_said_to_meet(const Values& values) {
  std::vector<Formula> any;
  for (const Order& order : orders())
    if (interiors_are_said_to_meet(order)) any.push_back(are_in_order(values, order));
  return any_of(any);
}

Corners corner(const Values& values, const std::string& of) {
  return {direction(values, of + ".in"), direction(values, of + ".out")};
}

Formula is_in_both_sectors(const Values& values, const Vectors& d) {
  return all_of({is_in_sector(d, corner(values, "p")), is_in_sector(d, corner(values, "q"))});
}

/// What both sectors have in common ends at rays: between two of them, less than π apart, is their sum;
/// where they are π apart, a vector to the left of one.
std::vector<Vectors> candidates(const Values& values) {
  std::vector<Vectors> all;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vectors u = vector_of(values, rays[i]);
    all.push_back(leftwards(u));
    for (std::size_t j = 0; j < rays.size(); ++j) {
      const Vectors v = vector_of(values, rays[j]);
      if (j < i) all.push_back(sum(u, v));
    }
  }
  return all;
}

Corner corner_in(const Model& model, const std::string& of) {
  return {direction_in(model, of + ".in"), direction_in(model, of + ".out")};
}

bool corners_meet(const Model& model) {
  return interiors_meet(region_with_corner(corner_in(model, "p")),
                        region_with_corner(corner_in(model, "q")));
}

std::vector<Unknown> unknowns(const std::vector<std::string>& names) {
  std::vector<Unknown> all;
  for (const std::string& name : names) all.push_back({name, Unknown::Kind::direction});
  return all;
}

Hypothesis turns(const std::string& of) {
  return {"turns-" + of,
          {"the corner of " + of + " does not turn back",
           [of](const Values& values) { return negation(turns_back(corner(values, of))); }}};
}

bool edges_meet(const Model& model) {
  return interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                        region_with_edge(direction_in(model, "f"), 1));
}

const RegisteredQueries registered({
    {.id = "section-5.1.1.said-to-meet",
     .statement = "section-5.1.1",
     .unknowns = unknowns({"p.in", "p.out", "q.in", "q.out"}),
     .hypotheses = {turns("p"),
                    turns("q"),
                    {"said", {"from the order of the rays the code says yes", are_said_to_meet}}},
     .conclusion = {"the sum of two rays or a vector to the left of one is in both sectors",
                    [](const Values& values) {
                      return one_is_in(candidates(values), [&](const Vectors& d) {
                        return is_in_both_sectors(values, d);
                      });
                    }},
     .dropped = "said",
     .is_false_by_definition = [](const Model& model) { return !corners_meet(model); }},
    {.id = "section-5.1.1.meet",
     .statement = "section-5.1.1",
     .unknowns = unknowns({"p.in", "p.out", "q.in", "q.out", "d"}),
     .hypotheses = {turns("p"),
                    turns("q"),
                    {"in-p",
                     {"d is in the sector of p",
                      [](const Values& values) {
                        return is_in_sector(direction(values, "d"), corner(values, "p"));
                      }}},
                    {"in-q",
                     {"d is in the sector of q",
                      [](const Values& values) {
                        return is_in_sector(direction(values, "d"), corner(values, "q"));
                      }}}},
     .conclusion = {"from the order of the rays the code says yes", are_said_to_meet},
     .dropped = "in-q",
     .is_false_by_definition = [](const Model& model) { return !corners_meet(model); }},
    {.id = "section-5.1.1.proper-crossing",
     .statement = "section-5.1.1",
     .unknowns = unknowns({"e", "f"}),
     .hypotheses = {{"cross",
                     {"e and f are not parallel",
                      [](const Values& values) {
                        return negation(
                            are_parallel(direction(values, "e"), direction(values, "f")));
                      }}}},
     .conclusion = {"e - f or f - e points to the left of both",
                    [](const Values& values) {
                      const Vectors e = direction(values, "e"), f = direction(values, "f");
                      return one_is_in({sum(e, opposite(f)), sum(f, opposite(e))},
                                       [&](const Vectors& d) {
                                         return all_of({is_left(e, d), is_left(f, d)});
                                       });
                    }},
     .dropped = "cross",
     .of_twin = {{"e and f are not equal",
                  [](const Values& values) {
                    return negation(are_equal(direction(values, "e"), direction(values, "f")));
                  }}},
     .is_false_by_definition = [](const Model& model) { return !edges_meet(model); }},
    {.id = "section-5.1.1.overlap-one-way",
     .statement = "section-5.1.1",
     .unknowns = unknowns({"e", "f"}),
     .hypotheses = {{"equal",
                     {"e and f have equal directions",
                      [](const Values& values) {
                        return are_equal(direction(values, "e"), direction(values, "f"));
                      }}}},
     .conclusion = {"a vector to the left of e points to the left of f",
                    [](const Values& values) {
                      return is_left(direction(values, "f"), leftwards(direction(values, "e")));
                    }},
     .dropped = "equal",
     .of_twin = {{"e and f are parallel",
                  [](const Values& values) {
                    return are_parallel(direction(values, "e"), direction(values, "f"));
                  }}},
     .is_false_by_definition = [](const Model& model) { return !edges_meet(model); }},
    {.id = "section-5.1.1.overlap-both-ways",
     .statement = "section-5.1.1",
     .unknowns = unknowns({"e", "f", "d"}),
     .hypotheses = {{"opposite",
                     {"e and f have opposite directions",
                      [](const Values& values) {
                        return are_equal(direction(values, "e"), opposite(direction(values, "f")));
                      }}}},
     .conclusion = {"d does not point to the left of both",
                    [](const Values& values) {
                      const Vectors d = direction(values, "d");
                      return negation(all_of({is_left(direction(values, "e"), d),
                                              is_left(direction(values, "f"), d)}));
                    }},
     .dropped = "opposite",
     .is_false_by_definition = edges_meet},
});

}  // namespace

}  // namespace oplus::smt
