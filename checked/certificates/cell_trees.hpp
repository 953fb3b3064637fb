// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "checked/certificates/seams.hpp"

namespace oplus::certificates {

struct Cut {
  IntegerLine line;
  Seam seam;  ///< of an open sum's cut; usual is the pair of the first leaf of the negative part
};

/// A step of a tree in preorder: a cut, followed by the tree of what is on its positive side and that of what is
/// on its negative one; or a pair of pieces whose sum contains the cell.
using Step = std::variant<Cut, PieceSums::Pair>;
using Tree = std::vector<Step>;

/// The first pair of a tree.
PieceSums::Pair first_leaf(const Tree& tree);

/// Cuts convex pieces of a sum into cells, each inside a sum T ⊕ U of two pieces of the summands: along sides of
/// a T ⊕ U that covers much of a cell and, if there is one, has a side all along the first cut.
class CellTrees {
 public:
  /// `seams`: of an open sum, else null.
  CellTrees(PieceSums& sums, const ShiftedDoubles& doubles, Seams* seams)
      : sums_(sums), doubles_(doubles), seams_(seams), error_(sums.error()) {}

  /// Throws PointOutsideSum. Requires: the corners are those of a convex piece.
  Tree tree(const std::vector<Point>& corners);

 private:
  using Pair = PieceSums::Pair;

  /// What is not in the tree yet, the next one last; perhaps with the pair whose sum is to contain it.
  struct OpenCell {
    Cell cell;
    std::optional<Pair> pair;
  };

  /// The ends of a cut.
  struct Ends {
    Seams::Corner from, to;
  };

  void add_step(const Cell& cell);
  /// Cuts off what is beyond a side of the pair's sum. Returns false if that is all of the cell.
  bool add_step(const Cell& cell, const Pair& pair);
  void add_seams();
  Pair pair_exactly_around(const Cell& cell);
  bool contains(const Pair& pair, const Cell& cell);
  double worth(const Pair& pair, const Cell& cell);

  // Of the sum with these half planes:
  /// which share of a side's line inside the cell is on its boundary,
  double share_on_boundary(std::size_t side, const Cell& cell) const;
  /// and twice the area that it covers.
  double covered_area(const Cell& cell) const;
  Sides sides_of(const Pair& pair, std::size_t side, const Cell& cell);

  PieceSums& sums_;
  const ShiftedDoubles& doubles_;
  Seams* seams_;
  double error_;  ///< of what is above a half plane
  Tree tree_;
  std::vector<Ends> ends_;  ///< of the tree's cuts, in their order
  std::vector<OpenCell> open_;
  std::vector<HalfPlane> half_planes_;
};

}  // namespace oplus::certificates
