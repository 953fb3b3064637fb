// SPDX-License-Identifier: MIT
#include "checked/verify/collision_verdicts.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "checked/verify/overlay.hpp"
#include "reference/definitions/cells.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/definitions/verdicts_differ.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Orientations: some hundredths of a second.
constexpr std::size_t most_spent_on_definition = 1 << 17;

std::vector<Point> vertices(const Region& region, const std::vector<Segment>& other) {
  std::vector<Point> all;
  const SegmentTree met(other);
  for (const Segment& e : edges(region))
    for (const Segment& piece : cut_where_met(e, met)) all.push_back(piece.source);
  return sorted_without_copies(std::move(all));
}

}  // namespace

CollisionVerdicts::CollisionVerdicts(const Region& p, const Region& q)
    : p_(p),
      q_(q),
      test_(hierarchy_collision(p, q)),
      cost_of_definition_((vertex_count(p) + vertex_count(q)) *
                          (vertex_count(p) + vertex_count(q))) {}

CollisionVerdicts::~CollisionVerdicts() = default;

bool CollisionVerdicts::interiors_meet_at(const Point& x) const {
  return test_->interiors_meet_at(x);
}

bool CollisionVerdicts::interiors_meet_by_definition_at(const Point& x) const {
  const bool meet = interiors_meet_at(x);
  if (spent_on_it_ + cost_of_definition_ > most_spent_on_definition) return meet;
  spent_on_it_ += cost_of_definition_;
  if (interiors_meet(p_, translated(reflected(q_), x)) != meet)
    throw VerdictsDiffer("the collision test and its definition differ at " + to_string(x));
  return meet;
}

std::optional<Point> CollisionVerdicts::common_point_at(const Point& x) const {
  const Region placed = translated(reflected(q_), x);
  PlanarSet chains;
  for (const Component& component : placed.components) {
    chains.outer.push_back(component.outer);
    chains.holes.insert(chains.holes.end(), component.holes.begin(), component.holes.end());
  }
  if (std::optional<Point> inside = Overlay({p_, {}, {}}, chains).common_point()) return inside;
  const std::vector<Point> of_p = vertices(p_, edges(placed));
  const std::vector<Point> of_q = vertices(placed, edges(p_));
  std::vector<Point> common;
  std::set_intersection(of_p.begin(), of_p.end(), of_q.begin(), of_q.end(),
                        std::back_inserter(common));
  return common.empty() ? std::nullopt : std::optional(common[0]);
}

}  // namespace oplus
