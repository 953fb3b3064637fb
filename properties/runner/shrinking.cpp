// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/shrinking.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/validity.hpp"

namespace oplus {

namespace {

using Accept = std::function<bool(const Summands&)>;
using Move = std::function<Rational(const Rational&)>;

constexpr std::array<Region Summands::*, 2> both{&Summands::p, &Summands::q};
constexpr std::array<Rational Point::*, 2> axes{&Point::x, &Point::y};

Rational rounded_towards_zero(const Rational& value) {
  return mpz_class(value.get_num() / value.get_den());
}

/// The ways to make one coordinate simpler, the largest step first.
const std::vector<Move>& moves() {
  static const std::vector<Move> all{
      [](const Rational&) { return Rational(0); },
      [](const Rational& v) { return rounded_towards_zero(v / 16); },
      [](const Rational& v) { return rounded_towards_zero(v / 2); },
      [](const Rational& v) { return rounded_towards_zero(v); },
      [](const Rational& v) { return Rational(v - sign(v)); },
      // From a fraction to one of half the denominator, not to the integers at once.
      [](const Rational& v) {
        const mpz_class half = v.get_den() / 2;
        if (half == 0) return v;
        return Rational(rounded_towards_zero(v * half) / half);
      },
  };
  return all;
}

template <typename Change>
void for_each_point(Region& region, Change change) {
  for (Component& component : region.components) {
    for (Point& p : component.outer) change(p);
    for (Chain& hole : component.holes)
      for (Point& p : hole) change(p);
  }
}

Region moved(Region region, const Move& move) {
  for_each_point(region, [&](Point& p) { p = {move(p.x), move(p.y)}; });
  return region;
}

std::set<Rational> values(Region region, Rational Point::*axis) {
  std::set<Rational> result;
  for_each_point(region, [&](Point& p) { result.insert(p.*axis); });
  return result;
}

std::vector<Chain*> chains_in(Region& region) {
  std::vector<Chain*> result;
  for (Component& component : region.components) {
    result.push_back(&component.outer);
    for (Chain& hole : component.holes) result.push_back(&hole);
  }
  return result;
}

bool well_oriented(const Region& region) {
  return std::all_of(region.components.begin(), region.components.end(), [](const Component& c) {
    return sign(twice_area(c.outer)) > 0 &&
           std::all_of(c.holes.begin(), c.holes.end(),
                       [](const Chain& hole) { return sign(twice_area(hole)) < 0; });
  });
}

bool is_valid(const Region& region) { return well_oriented(region) && !find_defect(region); }

/// Makes the candidates one after the other until one is accepted, so that `shrink` need not make
/// those behind it.
class Candidates {
 public:
  Candidates(const Summands& from, const Accept& accept)
      : from_(from), size_(size_of(from)), accept_(accept) {}

  /// Returns whether one was accepted.
  bool visit() {
    return fewer_components() || fewer_holes() || fewer_vertices() || opened_holes() ||
           simpler_together() || simpler_regions() || simpler_lines() || simpler_points();
  }

 private:
  bool offer(Summands candidate) const {
    return size_of(candidate) < size_ && is_valid(candidate.p) && is_valid(candidate.q) &&
           accept_(candidate);
  }

  /// Offers the pair with one region changed.
  template <typename Change>
  bool offer_changed(Region Summands::*which, Change change) const {
    Summands candidate = from_;
    change(candidate.*which);
    return offer(std::move(candidate));
  }

  bool fewer_components() const {
    for (const auto which : both) {
      const std::size_t count = (from_.*which).components.size();
      if (count <= 1) continue;
      for (std::size_t i = 0; i < count; ++i) {
        if (offer_changed(which, [&](Region& r) { r.components = {Component(r.components[i])}; }))
          return true;
      }
      for (std::size_t i = 0; count > 2 && i < count; ++i) {
        if (offer_changed(which, [&](Region& r) {
              r.components.erase(r.components.begin() + static_cast<std::ptrdiff_t>(i));
            }))
          return true;
      }
    }
    return false;
  }

  bool fewer_holes() const {
    for (const auto which : both) {
      for (std::size_t c = 0; c < (from_.*which).components.size(); ++c) {
        const std::size_t count = (from_.*which).components[c].holes.size();
        if (count > 1 && offer_changed(which, [&](Region& r) { r.components[c].holes.clear(); }))
          return true;
        for (std::size_t h = 0; h < count; ++h) {
          if (offer_changed(which, [&](Region& r) {
                std::vector<Chain>& holes = r.components[c].holes;
                holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(h));
              }))
            return true;
        }
      }
    }
    return false;
  }

  /// Leaves out runs of vertices: halves of a chain, quarters, and so on down to one.
  bool fewer_vertices() const {
    for (const auto which : both) {
      const std::vector<Chain> all = chains(from_.*which);
      for (std::size_t c = 0; c < all.size(); ++c) {
        const std::size_t length = all[c].size();
        for (std::size_t run = length / 2; run > 0; run /= 2) {
          if (length < run + 3) continue;
          for (std::size_t first = 0; first < length; first += run) {
            if (offer_changed(which, [&](Region& r) {
                  Chain rotated = all[c];
                  std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(first),
                              rotated.end());
                  rotated.erase(rotated.begin(),
                                rotated.begin() + static_cast<std::ptrdiff_t>(run));
                  *chains_in(r)[c] = std::move(rotated);
                }))
              return true;
          }
        }
      }
    }
    return false;
  }

  /// Turns a hole into a dent of the outer chain, of one of its vertices or all but one: what needs
  /// a reflex vertex needs no hole.
  bool opened_holes() const {
    for (const auto which : both) {
      const Region& region = from_.*which;
      for (std::size_t c = 0; c < region.components.size(); ++c) {
        for (std::size_t h = 0; h < region.components[c].holes.size(); ++h) {
          const Chain& hole = region.components[c].holes[h];
          for (const std::size_t depth : {std::size_t{1}, hole.size() - 1}) {
            for (std::size_t first = 0; first < hole.size(); ++first) {
              Chain dent = hole;
              std::rotate(dent.begin(), dent.begin() + static_cast<std::ptrdiff_t>(first),
                          dent.end());
              dent.resize(depth);
              for (std::size_t edge = 1; edge <= region.components[c].outer.size(); ++edge) {
                if (offer_changed(which, [&](Region& r) {
                      Component& component = r.components[c];
                      component.holes.erase(component.holes.begin() +
                                            static_cast<std::ptrdiff_t>(h));
                      component.outer.insert(
                          component.outer.begin() + static_cast<std::ptrdiff_t>(edge), dent.begin(),
                          dent.end());
                    }))
                  return true;
              }
            }
          }
        }
      }
    }
    return false;
  }

  /// Both regions at once: scaled to integers, by a common factor, rounded, each moved to the
  /// origin. The first two leave the sum as it was but for its scale.
  bool simpler_together() const {
    mpz_class denominators = 1;
    mpz_class numerators = 0;
    for (const auto which : both) {
      for (const auto axis : axes) {
        for (const Rational& v : values(from_.*which, axis)) {
          denominators = lcm(denominators, v.get_den());
          numerators = gcd(numerators, v.get_num());
        }
      }
    }
    if (denominators > 1 &&
        offer_both([&](const Rational& v) -> Rational { return v * denominators; }))
      return true;
    if (numerators > 1 && offer_both([&](const Rational& v) -> Rational { return v / numerators; }))
      return true;
    if (offer({at_origin(from_.p), at_origin(from_.q)})) return true;
    for (const Move& move : moves()) {
      if (offer_both(move)) return true;
    }
    return false;
  }

  bool offer_both(const Move& move) const {
    return offer({moved(from_.p, move), moved(from_.q, move)});
  }

  static Region at_origin(const Region& region) {
    if (region.components.empty()) return region;
    return translated(region,
                      {-*values(region, &Point::x).begin(), -*values(region, &Point::y).begin()});
  }

  /// One region: moved so that its corner, middle or a vertex becomes the origin, coordinates
  /// replaced by their ranks, or all simplified in the same way.
  bool simpler_regions() const {
    for (const auto which : both) {
      const Region& region = from_.*which;
      if (offer_changed(which, [](Region& r) { r = at_origin(r); })) return true;
      for (const Chain& chain : chains(region)) {
        for (const Point& p : chain) {
          if (offer_changed(which, [&](Region& r) { r = translated(r, -p); })) return true;
        }
      }
      if (offer_changed(which, [](Region& r) { r = ranked(r); })) return true;
      for (const Move& move : moves()) {
        if (offer_changed(which, [&](Region& r) { r = moved(r, move); })) return true;
      }
    }
    return false;
  }

  static Region ranked(Region region) {
    for (const auto axis : axes) {
      const std::set<Rational> sorted = values(region, axis);
      for_each_point(region, [&](Point& p) {
        p.*axis = static_cast<unsigned long>(std::distance(sorted.begin(), sorted.find(p.*axis)));
      });
    }
    return region;
  }

  /// All vertices with a coordinate in common, so that edges parallel to an axis stay that.
  bool simpler_lines() const {
    for (const auto which : both) {
      for (const auto axis : axes) {
        for (const Rational& line : values(from_.*which, axis)) {
          for (const Move& move : moves()) {
            const Rational to = move(line);
            if (to == line) continue;
            if (offer_changed(which, [&](Region& r) {
                  for_each_point(r, [&](Point& p) {
                    if (p.*axis == line) p.*axis = to;
                  });
                }))
              return true;
          }
        }
      }
    }
    return false;
  }

  bool simpler_points() const {
    for (const auto which : both) {
      const std::vector<Chain> all = chains(from_.*which);
      for (std::size_t c = 0; c < all.size(); ++c) {
        for (std::size_t v = 0; v < all[c].size(); ++v) {
          for (const auto axis : axes) {
            for (const Move& move : moves()) {
              const Rational to = move(all[c][v].*axis);
              if (to == all[c][v].*axis) continue;
              if (offer_changed(which, [&](Region& r) { (*chains_in(r)[c])[v].*axis = to; }))
                return true;
            }
          }
        }
      }
    }
    return false;
  }

  const Summands& from_;
  const Size size_;
  const Accept& accept_;
};

}  // namespace

std::vector<Summands> smaller(const Summands& summands) {
  std::vector<Summands> all;
  const Accept collect = [&](const Summands& candidate) {
    if (std::find(all.begin(), all.end(), candidate) == all.end()) all.push_back(candidate);
    return false;
  };
  Candidates(summands, collect).visit();
  return all;
}

Size size_of(const Summands& summands) {
  Size size;
  for (const Region* region : {&summands.p, &summands.q}) {
    size.vertices += vertex_count(*region);
    for (const Chain& chain : chains(*region)) {
      for (const Point& p : chain)
        size.coordinates += abs(p.x.get_num()) + p.x.get_den() + abs(p.y.get_num()) + p.y.get_den();
    }
  }
  return size;
}

Summands shrink(Summands summands, const std::function<bool(const Summands&)>& fails) {
  // Always checked: a verdict that changes from call to call would shrink to nonsense.
  if (!fails(summands)) throw ContractViolation("shrink: the pair to start from does not fail");
  Summands next;
  const Accept accept = [&](const Summands& candidate) {
    if (!fails(candidate)) return false;
    next = candidate;
    return true;
  };
  while (Candidates(summands, accept).visit()) summands = std::move(next);
  return summands;
}

}  // namespace oplus
