// SPDX-License-Identifier: MIT
#include <algorithm>
#include <mutex>
#include <thread>
#include <utility>

#include "checked/engine.hpp"
#include "checked/oplus/oplus.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/verify.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

struct Sum::State {
  MinkowskiSum value;
  Boundary boundary;
  Origins origins;
  Statistics statistics;
  mutable std::once_flag is_region_computed = {};
  mutable ValidRegion region = {};
};

Sum::Sum(MinkowskiSum value, Boundary boundary, Origins origins, Statistics statistics)
    : state_(std::make_shared<State>(std::move(value), boundary, std::move(origins),
                                     std::move(statistics))) {}

Boundary Sum::boundary() const { return state_->boundary; }

const ValidRegion& Sum::region() const& {
  std::call_once(state_->is_region_computed,
                 [&] { state_->region = ValidRegion::found_valid(region_of(state_->value)); });
  return state_->region;
}

const std::vector<Component>& Sum::components() const& { return region().components(); }

const std::vector<Segment>& Sum::dangling_edges() const& { return value().dangling_edges; }

const std::vector<Point>& Sum::isolated_vertices() const& { return value().isolated_vertices; }

const MinkowskiSum& Sum::value() const& { return state_->value; }

const Origins& Sum::origins() const& { return state_->origins; }

const Statistics& Sum::statistics() const& { return state_->statistics; }

Sum minkowski_sum(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  // A system call, which would take longer than some sums.
  static const unsigned processors = std::max(std::thread::hardware_concurrency(), 1U);
  const EngineOptions how = {.with_origins = options.with_origins,
                             .threads = options.threads != 0 ? options.threads : processors};
  ComputedSum computed =
      options.engine == nullptr
          ? slide_sum(p.region(), q.region(), options.boundary, how)
          : options.engine->compute(p.region(), q.region(), options.boundary, how);
  return Sum(std::move(computed.sum), options.boundary, std::move(computed.origins),
             std::move(computed.statistics));
}

Rational area(const Sum& sum) { return area(sum.value()); }

Location locate(const Coordinates& point, const Sum& sum) {
  return locate(point.point(), sum.value());
}

bool contains(const Sum& sum, const Coordinates& point) {
  const Location location = locate(point, sum);
  return location == Location::inside ||
         (location == Location::boundary && sum.boundary() == Boundary::closed);
}

Verdict verify(const ValidRegion& p, const ValidRegion& q, const GivenSum& given,
               Boundary boundary) {
  const auto canonical = [](const Point& point) { return Coordinates(point).point(); };
  GivenSum sum = {mapped(given.region, canonical), given.dangling_edges, given.isolated_vertices};
  for (Segment& edge : sum.dangling_edges) edge = {canonical(edge.source), canonical(edge.target)};
  for (Point& vertex : sum.isolated_vertices) vertex = canonical(vertex);
  return verify(p.region(), q.region(), boundary, sum);
}

Verdict verify(const ValidRegion& p, const ValidRegion& q, const Sum& sum) {
  return verify(p.region(), q.region(), sum.boundary(), sum.value());
}

}  // namespace oplus
