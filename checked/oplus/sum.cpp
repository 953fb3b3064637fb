// SPDX-License-Identifier: MIT
#include <algorithm>
#include <mutex>
#include <thread>
#include <utility>

#include "checked/engine.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "checked/oplus/internal/sum_options.hpp"
#include "checked/oplus/oplus.hpp"
#include "checked/rounding/rounding.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/verify.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

void require_bounded(const ValidRegion& p, const ValidRegion& q) {
  if (is_unbounded(p) || is_unbounded(q))
    throw InvalidInput({"region", 0, 0}, "a summand is unbounded", "bounded regions");
}

}  // namespace

struct ValidSet::State {
  PlanarSet value;
  Boundary boundary;
  Origins origins;
  Statistics statistics;
  mutable std::once_flag is_region_computed = {};
  mutable ValidRegion region = {};
};

ValidSet::ValidSet(PlanarSet value, Boundary boundary, Origins origins, Statistics statistics)
    : state_(new State{std::move(value), boundary, std::move(origins), std::move(statistics)}) {}

ValidSet set_of(PlanarSet value, Boundary boundary, Origins origins, Statistics statistics) {
  return ValidSet(std::move(value), boundary, std::move(origins), std::move(statistics));
}

Boundary ValidSet::boundary() const { return state_->boundary; }

const ValidRegion& ValidSet::region() const& {
  std::call_once(state_->is_region_computed,
                 [&] { state_->region = ValidRegion::found_valid(region_of(state_->value)); });
  return state_->region;
}

const std::vector<Component>& ValidSet::components() const& { return region().components(); }

const std::vector<Segment>& ValidSet::dangling_edges() const& { return value().dangling_edges; }

const std::vector<Point>& ValidSet::isolated_vertices() const& { return value().isolated_vertices; }

const PlanarSet& ValidSet::value() const& { return state_->value; }

const Origins& ValidSet::origins() const& { return state_->origins; }

const Statistics& ValidSet::statistics() const& { return state_->statistics; }

namespace {

EngineOptions engine_options(const SumOptions& options) {
  // A system call, which would take longer than some sums.
  static const unsigned processors = std::max(std::thread::hardware_concurrency(), 1U);
  return {.with_origins = options.with_origins,
          .threads = options.threads != 0 ? options.threads : processors,
          .progress = options.progress};
}

}  // namespace

ComputedSum computed_sum(const Region& p, const Region& q, Boundary boundary,
                         const SumOptions& options) {
  const EngineOptions how = engine_options(options);
  return options.engine == nullptr ? slide_sum(p, q, boundary, how)
                                   : options.engine->compute(p, q, boundary, how);
}

namespace {

/// How a sum is computed with these options, which says what it took.
SumOf sum_of(const SumOptions& options, Statistics& statistics) {
  return [&](const Region& a, const Region& b, Boundary boundary) {
    ComputedSum computed = computed_sum(a, b, boundary, options);
    statistics = std::move(computed.statistics);
    return std::move(computed.sum);
  };
}

}  // namespace

namespace {

/// Its points, where it is closed, or its closure.
const PlanarSet& summand(const ValidSet& set) {
  if (set.boundary() == Boundary::open &&
      !(set.dangling_edges().empty() && set.isolated_vertices().empty()))
    throw InvalidInput({"summand", 0, 0}, "an open set with dangling edges or isolated vertices",
                       "a closed set, such as its region");
  return set.value();
}

}  // namespace

ValidSet minkowski_sum(const ValidSet& p, const ValidSet& q, const SumOptions& options) {
  Statistics statistics;
  PlanarSet sum =
      unbounded_sum(summand(p), summand(q), options.boundary, sum_of(options, statistics));
  return set_of(std::move(sum), options.boundary, {}, std::move(statistics));
}

ValidSet minkowski_sum(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  if (is_unbounded(p) || is_unbounded(q)) {
    if (options.with_origins) require_bounded(p, q);
    Statistics statistics;
    PlanarSet sum =
        unbounded_sum(p.region(), q.region(), options.boundary, sum_of(options, statistics));
    return set_of(std::move(sum), options.boundary, {}, std::move(statistics));
  }
  ComputedSum computed = computed_sum(p.region(), q.region(), options.boundary, options);
  return set_of(std::move(computed.sum), options.boundary, std::move(computed.origins),
                std::move(computed.statistics));
}

struct PreparedRegion::State {
  explicit State(ValidRegion of)
      : region(std::move(of)),
        summand(std::shared_ptr<const Region>(std::shared_ptr<void>(), &region.region())) {}

  ValidRegion region;
  slide::PreparedSummand summand;  ///< refers to the region
};

PreparedRegion::PreparedRegion(ValidRegion region)
    : state_(std::make_shared<const State>(std::move(region))) {}

const ValidRegion& PreparedRegion::region() const { return state_->region; }

ValidSet minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                       const SumOptions& options) {
  if (options.engine != nullptr || is_unbounded(p.region()) || is_unbounded(q.region()))
    return minkowski_sum(p.region(), q.region(), options);
  ComputedSum computed = sum_of_prepared(p.state_->summand, q.state_->summand, options.boundary,
                                         engine_options(options));
  return set_of(std::move(computed.sum), options.boundary, std::move(computed.origins),
                std::move(computed.statistics));
}

Rounded ValidSet::rounded_value(const PlanarSet& value, Boundary boundary, const Number& step,
                                Side side) {
  if (sgn(step.value()) <= 0)
    throw InvalidInput({"the step of a grid", 0, 0}, to_string(step.value()) + " is not positive",
                       "a number above 0");
  RoundedSet set = oplus::rounded(value, boundary, step.value(), side);
  Rounded result{ValidSet(std::move(set.set), boundary, {}, {}), set.changes, set.is_exact,
                 std::move(set.bound)};
  std::call_once(result.sum.state_->is_region_computed, [&] {
    result.sum.state_->region = ValidRegion::found_valid(std::move(set.region));
  });
  return result;
}

Rounded rounded(const ValidSet& sum, const Number& step, Side side) {
  return ValidSet::rounded_value(sum.value(), sum.boundary(), step, side);
}

Rounded rounded(const ValidRegion& region, const Number& step, Side side) {
  return ValidSet::rounded_value(canonical_sum(region.region()), Boundary::closed, step, side);
}

Rational area(const ValidSet& sum) { return area(sum.value()); }

Location locate(const Coordinates& point, const ValidSet& sum) {
  return locate(point.point(), sum.value());
}

bool contains(const ValidSet& sum, const Coordinates& point) {
  const Location location = locate(point, sum);
  return location == Location::inside ||
         (location == Location::boundary && sum.boundary() == Boundary::closed);
}

Verdict verify(const ValidRegion& p, const ValidRegion& q, const ClaimedSum& given,
               Boundary boundary) {
  require_bounded(p, q);
  const auto canonical = [](const Point& point) { return Coordinates(point).point(); };
  ClaimedSum sum = {mapped(given.region, canonical), given.dangling_edges, given.isolated_vertices};
  for (Segment& edge : sum.dangling_edges) edge = {canonical(edge.source), canonical(edge.target)};
  for (Point& vertex : sum.isolated_vertices) vertex = canonical(vertex);
  return verify(p.region(), q.region(), boundary, sum);
}

Verdict verify(const ValidRegion& p, const ValidRegion& q, const ValidSet& sum) {
  require_bounded(p, q);
  if (sum.value().is_unbounded)
    throw InvalidInput({"sum", 0, 0}, "the sum is unbounded", "a bounded one");
  return verify(p.region(), q.region(), sum.boundary(), sum.value());
}

}  // namespace oplus
