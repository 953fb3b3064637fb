// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include "checked/slide/component_tree.hpp"
#include "checked/slide/integer_summand.hpp"

namespace oplus::slide {

/// Whether a summand is convex.
template <typename Numbers>
bool is_convex(const IntegerSummand<Numbers>& summand) {
  if (summand.first_of_chain.size() > 1) return false;
  for (std::uint32_t i = 0; i < summand.edges.size(); ++i) {
    const auto& entering = summand.edges[summand.previous[i]];
    if (sign_of(cross(entering.direction, summand.edges[i].direction)) < 0) return false;
  }
  return true;
}

/// All that depends on one summand and the scaling only. Trees are built when they are first needed, once,
/// on whichever thread needs them: so several pairs may share it.
template <typename Numbers>
class KeptSummand {
 public:
  KeptSummand(const Region& region, const Scaling& scaling, const Scaling::Offset& offset)
      : summand_(integer_summand<Numbers>(region, scaling, offset)) {}

  const IntegerSummand<Numbers>& summand() const { return summand_; }

  /// Empty before prepare_boxes(), which each user must call. So for components().
  const FloatBoxTree& boxes() const { return boxes_; }
  const std::vector<LeadingBox>& leading_boxes() const { return leading_boxes_; }
  const ComponentTree& components() const { return components_; }

  void prepare_boxes(unsigned threads = 1) const {
    std::call_once(has_boxes_, [&] {
      boxes_ = float_box_tree(summand_, threads);
      leading_boxes_ = slide::leading_boxes(summand_, boxes_);
    });
  }
  /// Nobody uses them any more.
  void drop_boxes() { boxes_ = {}; }
  void prepare_components() const {
    std::call_once(has_components_, [this] { components_ = ComponentTree(summand_); });
  }

  /// Whether it is convex with few enough edges for ConvexCover.
  bool is_fit_to_cover() const {
    constexpr std::size_t most_edges = 128;  // each is looked at for each box
    if (summand_.edges.size() > most_edges) return false;
    std::call_once(has_convexity_, [this] { is_convex_ = is_convex(summand_); });
    return is_convex_;
  }

 private:
  IntegerSummand<Numbers> summand_;
  mutable std::once_flag has_boxes_, has_components_, has_convexity_;
  mutable FloatBoxTree boxes_;
  mutable std::vector<LeadingBox> leading_boxes_;
  mutable ComponentTree components_;
  mutable bool is_convex_ = false;
};

}  // namespace oplus::slide
