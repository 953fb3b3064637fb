// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <random>
#include <utility>

#include "checked/distance/distance.hpp"
#include "checked/operations/operations.hpp"
#include "checked/oplus/oplus.hpp"
#include "checked/slide/by_slide.hpp"
#include "reference/chains/near_point.hpp"
#include "reference/definitions/exact_box.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

// Distances and depths, pair by pair: nothing is kept from one to the next.

struct Distances {
  using Input = Summands;
  using Sum = NearestPoints;

  const Summands& converted(const Summands& pair) const { return pair; }
  NearestPoints sum(const Summands& pair) const { return distance(pair.p, pair.q); }
  void describe(const Summands&, const NearestPoints& nearest, Description& description) const {
    description.count("pairs", 1);
    description.count("apart", sgn(nearest.squared_distance) > 0);
  }
};

struct Depths {
  using Input = Summands;
  using Sum = std::optional<Overlap>;

  const Summands& converted(const Summands& pair) const { return pair; }
  Sum sum(const Summands& pair) const { return depth(pair.p, pair.q); }
  void describe(const Summands&, const Sum& overlap, Description& description) const {
    description.count("pairs", 1);
    description.count("overlaps", overlap.has_value());
  }
};

// Many places of one pair.

constexpr std::size_t places = 10000;

/// A pair's no-fit polygon, and places in the box around it.
struct Asked {
  explicit Asked(const Summands& pair) : no_fit(oplus::no_fit(pair.p, pair.q, by_slide)) {
    const ExactBox box = box_around(edges(no_fit));
    std::mt19937 random(1);
    const auto share = [&] { return Rational(random() >> 12, 1U << 20); };
    while (at.size() < places)
      at.push_back({box.low.x + share() * (box.high.x - box.low.x),
                    box.low.y + share() * (box.high.y - box.low.y)});
  }

  PlanarSet no_fit;
  std::vector<Point> at;
};

struct Located : Asked {
  explicit Located(const Summands& pair)
      : Asked(pair), placements(ValidRegion(pair.p), ValidRegion(pair.q)) {}

  Location locate(const Point& x) const { return placements.locate(x); }

  Placements placements;
};

/// A look at each edge: in doubles, and exactly where these don't decide.
struct Scanned : Asked {
  explicit Scanned(const Summands& pair) : Asked(pair), all(edges(no_fit)) {
    for (Segment& s : all)
      if (s.target < s.source) std::swap(s.source, s.target);
    for (const Segment& s : all) near.emplace_back(near_point(s.source), near_point(s.target));
  }
  Scanned(const Scanned&) = delete;  // near ones refer to exact ones
  Scanned& operator=(const Scanned&) = delete;

  Location locate(const Point& x) const {
    const NearPoint at_x = near_point(x);
    bool is_inside = false;
    for (const auto& [low, high] : near) {
      if (compare(at_x, low) < 0 || compare(at_x, high) > 0) continue;
      const int side = orientation(low, high, at_x);
      if (side == 0) return Location::boundary;
      if (side > 0 && compare(at_x, high) < 0) is_inside = !is_inside;
    }
    return is_inside ? Location::inside : Location::outside;
  }

  std::vector<Segment> all;
  std::vector<std::pair<NearPoint, NearPoint>> near;
};

template <typename Prepared>
struct Places {
  using Input = std::shared_ptr<const Prepared>;
  using Sum = std::string;

  Input converted(const Summands& pair) const { return std::make_shared<const Prepared>(pair); }
  std::string sum(const Input& pair) const {
    std::string answers;
    answers.reserve(pair->at.size());
    for (const Point& x : pair->at) answers += "oti"[static_cast<int>(pair->locate(x))];
    return answers;
  }
  void describe(const Input& pair, const std::string& answers, Description& description) const {
    description.count("places", pair->at.size());
    description.count("edges", edges(pair->no_fit).size());
    description.count("inside", static_cast<std::size_t>(std::ranges::count(answers, 'i')));
    description.say(answers);
  }
};

template <typename Method>
BenchEngine engine(const std::string& name, const std::string& what, const std::string& kind) {
  return {.name = name,
          .what = what,
          .prepare = each_pair([](const Row&) { return Method{}; }),
          .kind = kind};
}

}  // namespace

std::vector<BenchEngine> distance_engines() {
  return {
      engine<Distances>("distance", "oplus: the distance, and nearest points", "distances"),
      engine<Depths>("depth", "oplus: the depth of an overlap", "distances"),
      engine<Places<Located>>("placements", "oplus: places, asked of Placements", "places"),
      engine<Places<Scanned>>("scan", "oplus: the same by a look at each edge", "places"),
  };
}

}  // namespace oplus
