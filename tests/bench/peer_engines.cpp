// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "properties/compare/peers/boost_polygon_method.hpp"
#include "properties/compare/peers/cgal_methods.hpp"
#include "properties/compare/peers/clipper_method.hpp"
#include "tests/bench/described_sums.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

/// Exact sums in canonical form; of rounded ones the chains as they are.
MinkowskiSum sum_of(const ReturnedChains& chains, bool rounded) {
  if (rounded) {
    MinkowskiSum sum;
    for (const Chain& chain : chains)
      (twice_area(chain) > 0 ? sum.outer : sum.holes).push_back(chain);
    return sum;
  }
  BoundaryFeatures features;
  for (const Chain& chain : chains) {
    const std::vector<Segment> of_chain = edges(chain);
    features.edges.insert(features.edges.end(), of_chain.begin(), of_chain.end());
  }
  return canonical_sum(features);
}

/// What a `Method` has: method.hpp.
template <typename Method>
class PeerSums : public PreparedPairs {
 public:
  explicit PeerSums(const std::vector<Summands>& pairs) {
    for (const Summands& pair : pairs) inputs_.push_back(method_.converted(pair));
    sums_.reserve(pairs.size());
  }

  void compute() override {
    for (const Input& input : inputs_) sums_.push_back(method_.sum(input));
  }

  void forget() override { sums_.clear(); }

  bool evaluate() override {
    constexpr bool is_lazy = requires(const Sum& sum) { Method::evaluate(sum); };
    if constexpr (is_lazy)
      for (const Sum& sum : sums_) Method::evaluate(sum);
    return is_lazy;
  }

  void describe(Measurement& measurement) const override {
    constexpr bool rounds = Method::arithmetic == Arithmetic::rounding;
    std::vector<MinkowskiSum> sums;
    for (std::size_t i = 0; i < sums_.size(); ++i)
      sums.push_back(sum_of(method_.chains(inputs_[i], sums_[i]), rounds));
    describe_sums(sums, rounds, measurement);
  }

 private:
  using Input = typename Method::Input;
  using Sum = typename Method::Sum;

  Method method_;
  std::vector<Input> inputs_;
  std::vector<Sum> sums_;
};

template <typename Method>
BenchEngine engine_of(const std::string& name, const std::string& what) {
  return {name,
          what,
          Subject::sums,
          Method::arithmetic == Arithmetic::rounding,
          false,
          [](const Row&, const std::vector<Summands>& pairs) {
            return std::make_unique<PeerSums<Method>>(pairs);
          }};
}

}  // namespace

std::vector<BenchEngine> peer_engines() {
  return {
      engine_of<CgalReduced>("cgal-reduced", "CGAL: minkowski_sum_by_reduced_convolution_2"),
      engine_of<CgalFull>("cgal-full", "CGAL: minkowski_sum_by_full_convolution_2"),
      engine_of<CgalVertical>(
          "cgal-vertical",
          "CGAL: minkowski_sum_by_decomposition_2 with Polygon_vertical_decomposition_2"),
      engine_of<ClipperMethod>(
          "clipper", "Clipper 6: MinkowskiSum, filled by the summand into which the other may fit"),
      engine_of<BoostPolygonMethod>(
          "boost-polygon", "Boost.Polygon: its Minkowski example, then the polygon set's union"),
  };
}

}  // namespace oplus
