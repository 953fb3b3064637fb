// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/implementation.hpp"

#include <map>
#include <memory>
#include <utility>

#include "checked/arrangement/rca.hpp"
#include "checked/arrangement/sum_by_loops.hpp"
#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "checked/slide/slide.hpp"

namespace oplus {

namespace {

using Compute = std::function<ComputedSum(const Region& p, const Region& q, Boundary boundary,
                                          HoleTest& hole_test)>;

/// What remains of a hole test where faces are decided by winding numbers.
class PointsOf : public CollisionTest {
 public:
  explicit PointsOf(HoleTest& test) : test_(test) {}
  bool interiors_meet_at(const Point& x) override { return test_.interiors_meet_at(x); }

 private:
  HoleTest& test_;
};

Implementation implementation(const std::string& name, std::optional<HoleTestMethod> method,
                              Compute compute) {
  return {name, [method, compute = std::move(compute)](const Region& p, const Region& q,
                                                       Boundary boundary, Probes& probes) {
            if (!method) {
              ComparedHoleTests all(p, q, probes);
              return compute(p, q, boundary, all).sum;
            }
            const ComputedSum result = compute(p, q, boundary, *hole_test(*method, p, q));
            probes.faces += result.statistics.hole_tests;
            probes.points += result.statistics.point_tests;
            return result.sum;
          }};
}

std::vector<Implementation> table(std::optional<HoleTestMethod> method) {
  return {
      without_probes("slide", [](const Region& p, const Region& q,
                                 Boundary boundary) { return slide_sum(p, q, boundary).sum; }),
      implementation("rca", method,
                     [](const Region& p, const Region& q, Boundary boundary, HoleTest& hole_test) {
                       return rca(p, q, boundary, WithOrigins::no, hole_test);
                     }),
      implementation("loops", method,
                     [](const Region& p, const Region& q, Boundary boundary, HoleTest& hole_test) {
                       return sum_by_loops(p, q, boundary, WithOrigins::no, hole_test);
                     }),
      implementation("winding", method,
                     [](const Region& p, const Region& q, Boundary boundary, HoleTest& hole_test) {
                       PointsOf points(hole_test);
                       return sum_by_winding_numbers(p, q, boundary, WithOrigins::no, points);
                     }),
  };
}

}  // namespace

Implementation without_probes(
    std::string name,
    std::function<MinkowskiSum(const Region& p, const Region& q, Boundary boundary)> sum) {
  return {std::move(name),
          [sum = std::move(sum)](const Region& p, const Region& q, Boundary boundary,
                                 Probes& /*none*/) { return sum(p, q, boundary); }};
}

const std::vector<Implementation>& implementations(std::optional<HoleTestMethod> hole_test) {
  static const std::map<std::optional<HoleTestMethod>, std::vector<Implementation>> tables = [] {
    std::map<std::optional<HoleTestMethod>, std::vector<Implementation>> all;
    all.emplace(std::nullopt, table(std::nullopt));
    for (const auto& [name, method] : hole_test_methods()) all.emplace(method, table(method));
    return all;
  }();
  return tables.at(hole_test);
}

}  // namespace oplus
