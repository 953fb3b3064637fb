// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "checked/slide/integer_summand.hpp"
#include "checked/slide/short_list.hpp"

namespace oplus::slide {

/// All pairs of an edge of P and one of Q, in doubles. Comparing a segment with each of them is faster
/// than boxes where they are few.
///
/// The sum of two edges e and f, a parallelogram, is the intersection of two strips: one between its
/// sides along f, the other between those along e. The skew product with f, or with e, says how far a
/// point is across the strip. A segment is beside a strip iff their middles are farther apart than half
/// their widths together. All of this is stored twice as large.
class PairTable {
 public:
  /// What is added to the width of segments.
  struct Margins {
    double across;  ///< of those that run across the strip
    double along;   ///< of those along the strip
  };

  /// Empty where there are more pairs than `most` or more edges than fit.
  PairTable(std::span<const NearSegment> of_p, std::span<const NearSegment> of_q, std::size_t most);

  bool is_empty() const { return rows_.empty(); }

  /// Visits the numbers of all pairs of edges whose parallelogram a segment meets or is nearer to than
  /// the margins, and of some others.
  template <typename Visit>
  void each_near(const NearSegment& segment, const Margins& margins, const Visit& visit) const {
    Across<most_columns> columns;
    Across<most_rows / at_once> rows;
    find_across(segment, margins, columns_.data(), columns_.size(), columns.middles,
                columns.widths);
    find_across(segment, margins, edges_of_rows_.data(), edges_of_rows_.size(), rows.middles,
                rows.widths);
    const auto width = static_cast<std::uint32_t>(columns_.size());
    const std::uint32_t rows_at_once = bits_of_a_lane / width;
    for (std::uint32_t row = 0; row < rows_.size(); row += rows_at_once) {
      // Jumps that cannot be predicted would take most of the time: so pairs are remembered as bits.
      const auto end =
          std::min<std::uint32_t>(row + rows_at_once, static_cast<std::uint32_t>(rows_.size()));
      Bits met;
      find_met(row, end, columns.middles, columns.widths, rows.middles, rows.widths, met);
      for (std::uint32_t lane = 0; lane < at_once; ++lane)
        for (auto left = static_cast<std::uint64_t>(met[lane]); left != 0; left &= left - 1) {
          const auto place = static_cast<std::uint32_t>(std::countr_zero(left));
          visit(std::pair{row + place / width,
                          place % width * static_cast<std::uint32_t>(at_once) + lane});
        }
    }
  }

 private:
  // Of the compiler: processors that have no registers as wide compute with halves. As aligned as what allocators
  // return.
  typedef double Doubles __attribute__((vector_size(32), aligned(16)));
  typedef std::int64_t Bits __attribute__((vector_size(32), aligned(16)));
  static constexpr std::size_t at_once = sizeof(Doubles) / sizeof(double);
  static constexpr std::size_t bits_of_a_lane = 64;
  static constexpr std::size_t few_rows = 10;  ///< of fewer it is faster to look at all of them
  static constexpr std::size_t most_columns = 48;
  static constexpr std::size_t most_rows = 256;

  struct EdgesAtOnce {
    Doubles x, y, dx, dy;  ///< no numbers behind the last edge
  };

  struct Row {
    double low, high;  ///< where the strips along its edge are; unknown of few rows
  };

  struct Pairs {
    Doubles along_f;  ///< the middle, but for what depends on f and the segment only
    Doubles along_e;  ///< likewise
    Doubles width;
  };

  /// Where a segment is, across strips along edges.
  template <std::size_t most>
  struct Across {
    Doubles middles[most], widths[most];
  };

  static ShortList<EdgesAtOnce> at_once_each(std::span<const NearSegment> edges);

  /// The pairs of the edges with each row.
  static void fill(std::span<const NearSegment> edges, const ShortList<EdgesAtOnce>& columns,
                   Pairs* pairs);

  /// How far the middle of a segment is across strips along edges, twice, from where these start; and how far
  /// it reaches from there.
  static void find_across(const NearSegment& segment, const Margins& margins,
                          const EdgesAtOnce* edges, std::size_t count, Doubles* middles,
                          Doubles* widths);

  /// Which pairs of these rows are met: in each lane a bit for each of them, row by row.
  void find_met(std::uint32_t row, std::uint32_t end, const Doubles* middles_of_columns,
                const Doubles* widths_of_columns, const Doubles* middles_of_rows,
                const Doubles* widths_of_rows, Bits& met) const;

  ShortList<EdgesAtOnce> columns_;        ///< of Q
  ShortList<EdgesAtOnce> edges_of_rows_;  ///< of P
  ShortList<Row> rows_;                   ///< edge by edge of P
  ShortList<Pairs> pairs_;                ///< row by row
};

}  // namespace oplus::slide
