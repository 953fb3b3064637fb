// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/realized_pair.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <map>
#include <utility>

#include "reference/chains/validity.hpp"
#include "reference/families/lattice_polygon.hpp"

namespace oplus {

namespace {

/// What the grid is multiplied with.
mpz_class scale_of(const PairPlan& plan) {
  unsigned largest = 1;
  for (const PlannedSummand* summand : {&plan.p, &plan.q})
    for (const PlannedChain& chain : summand->chains)
      for (const PlannedVertex& v : chain.vertices)
        largest = std::max({largest, static_cast<unsigned>(std::abs(int{v.x})),
                            static_cast<unsigned>(std::abs(int{v.y}))});
  const int more = static_cast<int>(magnitudes.at(plan.magnitude)) - std::bit_width(largest);
  return mpz_class(1) << static_cast<unsigned>(std::max(more, 0));
}

class Realization {
 public:
  Realization(const PairPlan& plan, RealizedPair& result)
      : scale_(scale_of(plan)), is_sheared_(plan.is_sheared), result_(result) {}

  Region region(const PlannedSummand& summand) {
    // Mostly it is valid as it is planned, which takes one test of the whole.
    if (auto planned = as_planned(summand); planned && !find_defect(*planned)) return *planned;
    Region region;
    for (const PlannedChain& planned : summand.chains)
      if (!add(planned, summand, region)) ++result_.left_out;
    return region;
  }

 private:
  Point point(const PlannedVertex& v, const PlannedSummand& summand) const {
    Rational x = scale_ * v.x + v.jitter_x;
    Rational y = scale_ * v.y + v.jitter_y;
    if (is_sheared_) {
      const Rational before = x;
      // Of determinant one: as bijective as the identity.
      x += 3 * y;
      y = 5 * before + 16 * y;
    }
    const Rational& denominator = denominators().at(summand.denominator);
    const Rational& offset = offsets().at(summand.offset);
    return {x / denominator + offset, y / denominator - offset};
  }

  Chain chain(const std::vector<PlannedVertex>& vertices, const PlannedSummand& summand) const {
    Chain result;
    for (const PlannedVertex& v : vertices) result.push_back(point(v, summand));
    return result;
  }

  /// With each hole in the last component before it; nullopt where there is none.
  std::optional<Region> as_planned(const PlannedSummand& summand) const {
    Region region;
    for (const PlannedChain& planned : summand.chains) {
      if (planned.is_hole && region.components.empty()) return std::nullopt;
      Chain oriented_chain = oriented(chain(planned.vertices, summand), planned.is_hole ? -1 : 1);
      if (planned.is_hole)
        region.components.back().holes.push_back(std::move(oriented_chain));
      else
        region.components.push_back({std::move(oriented_chain), {}});
    }
    return region;
  }

  /// A simple chain of the same vertices or, of those in one place, one: none where that does not
  /// succeed soon.
  std::optional<Chain> simple_chain(const PlannedChain& planned, const PlannedSummand& summand) {
    Chain as_it_is = chain(planned.vertices, summand);
    if (!find_defect(polygon(oriented(as_it_is, 1)))) return as_it_is;
    std::map<std::pair<int, int>, PlannedVertex> at;
    for (const PlannedVertex& v : planned.vertices) at.emplace(std::pair{v.x, v.y}, v);
    std::vector<LatticePoint> places;
    for (const auto& [place, v] : at) places.push_back({place.first, place.second});
    if (places.size() < 3) return std::nullopt;
    Random same_each_time(places.size());
    const std::optional<Chain> untangled = polygon_through(same_each_time, places);
    if (!untangled) return std::nullopt;
    std::vector<PlannedVertex> vertices;
    for (const Point& v : *untangled)
      vertices.push_back(at.at({static_cast<int>(v.x.get_d()), static_cast<int>(v.y.get_d())}));
    Chain result = chain(vertices, summand);
    if (find_defect(polygon(oriented(result, 1)))) return std::nullopt;
    ++result_.untangled;
    return result;
  }

  bool add(const PlannedChain& planned, const PlannedSummand& summand, Region& region) {
    const std::optional<Chain> simple = simple_chain(planned, summand);
    if (!simple) return false;
    if (!planned.is_hole) {
      region.components.push_back({oriented(*simple, 1), {}});
      if (!find_defect(region)) return true;
      region.components.pop_back();
      return false;
    }
    for (auto component = region.components.rbegin(); component != region.components.rend();
         ++component) {
      component->holes.push_back(oriented(*simple, -1));
      if (!find_defect(region)) return true;
      component->holes.pop_back();
    }
    return false;
  }

  static Chain oriented(Chain chain, int wanted) {
    if (sign(twice_area(chain)) == -wanted) std::reverse(chain.begin(), chain.end());
    return chain;
  }

  mpz_class scale_;
  bool is_sheared_;
  RealizedPair& result_;
};

}  // namespace

std::optional<RealizedPair> realized(const PairPlan& plan) {
  RealizedPair result;
  Realization realization(plan, result);
  result.summands.p = realization.region(plan.p);
  if (result.summands.p.components.empty()) return std::nullopt;
  result.summands.q = realization.region(plan.q);
  if (result.summands.q.components.empty()) return std::nullopt;
  return result;
}

}  // namespace oplus
