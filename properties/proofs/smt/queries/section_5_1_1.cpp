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

Vectors vector_of(const Ray& ray) {
  const Vectors edge = direction(ray.edge);
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

Claim are_in_order(const Order& order) {
  std::vector<Claim> parts;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vectors u = vector_of(rays[i]), v = vector_of(rays[j]);
      const int expected = order[i] < order[j] ? -1 : order[i] > order[j] ? 1 : 0;
      parts.push_back(executed([=](const Values& values) {
        const int compared = cyclic_order::compare_angle(u(values), v(values));
        return (compared > 0) - (compared < 0) == expected;
      }));
    }
  }
  return all_of(parts);
}

Claim are_said_to_meet() {
  std::vector<Claim> any;
  for (const Order& order : orders())
    if (interiors_are_said_to_meet(order)) any.push_back(are_in_order(order));
  return any_of(any);
}

Claim is_in_both_sectors(const Vectors& d) {
  return all_of({is_in_sector(d, corner("p.")), is_in_sector(d, corner("q."))});
}

/// What both sectors have in common ends at rays: between two of them, less than π apart, is their sum;
/// where they are π apart, a vector to the left of one.
std::vector<Vectors> candidates() {
  std::vector<Vectors> all;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    all.push_back(leftwards(vector_of(rays[i])));
    for (std::size_t j = 0; j < i; ++j) all.push_back(sum(vector_of(rays[i]), vector_of(rays[j])));
  }
  return all;
}

bool corners_meet(const Model& model) {
  return interiors_meet(region_with_corner(corner_in(model, "p.")),
                        region_with_corner(corner_in(model, "q.")));
}

bool edges_meet(const Model& model) {
  return interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                        region_with_edge(direction_in(model, "f"), 1));
}

const Vectors e = direction("e"), f = direction("f"), d = direction("d");

const RegisteredQueries registered({
    {.id = "section-5.1.1.said-to-meet",
     .unknowns = {any_direction("p.in"), any_direction("p.out"), any_direction("q.in"),
                  any_direction("q.out")},
     .hypotheses = {{"said", {"from the order of the rays the code says yes", are_said_to_meet()}}},
     .conclusion = {"the sum of two rays or a vector to the left of one is in both sectors",
                    one_is_in(candidates(), is_in_both_sectors)},
     .is_false_by_definition = std::not_fn(corners_meet)},
    {.id = "section-5.1.1.meet",
     .unknowns = {any_direction("p.in"), any_direction("p.out"), any_direction("q.in"),
                  any_direction("q.out"), any_direction("d")},
     .hypotheses = {{"in-p", {"d is in the sector of p", is_in_sector(d, corner("p."))}},
                    {"in-q", {"d is in the sector of q", is_in_sector(d, corner("q."))}}},
     .conclusion = {"from the order of the rays the code says yes", are_said_to_meet()},
     .is_false_by_definition = std::not_fn(corners_meet)},
    {.id = "section-5.1.1.proper-crossing",
     .unknowns = {any_direction("e"), any_direction("f")},
     .hypotheses = {{"cross",
                     {"e and f are not parallel", negation(are_parallel(e, f))},
                     {{"e and f are not equal", negation(are_equal(e, f))}}}},
     .conclusion = {"e - f or f - e points to the left of both",
                    one_is_in({sum(e, opposite(f)), sum(f, opposite(e))},
                              [](const Vectors& n) {
                                return all_of({is_left(e, n), is_left(f, n)});
                              })},
     .is_false_by_definition = std::not_fn(edges_meet)},
    {.id = "section-5.1.1.overlap-one-way",
     .unknowns = {any_direction("e"), any_direction("f")},
     .hypotheses = {{"equal",
                     {"e and f have equal directions", are_equal(e, f)},
                     {{"e and f are parallel", are_parallel(e, f)}}}},
     .conclusion = {"a vector to the left of e points to the left of f", is_left(f, leftwards(e))},
     .is_false_by_definition = std::not_fn(edges_meet)},
    {.id = "section-5.1.1.overlap-both-ways",
     .unknowns = {any_direction("e"), any_direction("f"), any_direction("d")},
     .hypotheses = {{"opposite", {"e and f have opposite directions", are_equal(e, opposite(f))}}},
     .conclusion = {"d does not point to the left of both",
                    negation(all_of({is_left(e, d), is_left(f, d)}))},
     .is_false_by_definition = edges_meet},
});

}  // namespace

}  // namespace oplus::smt
