// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <experimental/simd>
#include <limits>
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

  /// Empty where there are more pairs than `most` or more edges of Q than fit.
  template <typename Edges>
  PairTable(const Edges& of_p, const Edges& of_q, std::size_t most) {
    if (of_p.size() * of_q.size() > most || of_q.size() > most_columns * at_once) return;
    for (std::size_t j = 0; j < of_q.size(); j += at_once) {
      const auto all = [&](auto member) {
        return Doubles([&](auto lane) {
          return j + lane < of_q.size() ? of_q[j + lane].*member
                                        : std::numeric_limits<double>::quiet_NaN();
        });
      };
      columns_.push_back({all(&NearSegment::x), all(&NearSegment::y), all(&NearSegment::dx),
                          all(&NearSegment::dy)});
    }
    for (const NearSegment& e : of_p) {
      const auto row = static_cast<std::uint32_t>(rows_.size());
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::uint32_t j = 0; j < columns_.size(); ++j) {
        const Columns& f = columns_[j];
        const Doubles area = e.dx * f.dy - e.dy * f.dx;
        pairs_.push_back({2 * (e.x * f.dy - e.y * f.dx) + area,
                          2 * (e.dx * f.y - e.dy * f.x) + area, abs(area)});
        first_of_pairs_.emplace_back(row, j * static_cast<std::uint32_t>(at_once));
        const Pairs& pairs = pairs_.back();
        for (std::size_t lane = 0; lane < at_once; ++lane) {
          low = std::min(low, pairs.along_e[lane] - pairs.width[lane]);
          high = std::max(high, pairs.along_e[lane] + pairs.width[lane]);
        }
      }
      rows_.push_back({e, low, high});
    }
  }

  bool is_empty() const { return rows_.empty(); }

  /// Visits the numbers of all pairs of edges whose parallelogram a segment meets or is nearer to than
  /// the margins, and of some others.
  template <typename Visit>
  void each_near(const NearSegment& segment, const Margins& margins, const Visit& visit) const {
    std::array<Doubles, most_columns> place_of_columns, width_of_columns;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const Columns& f = columns_[j];
      const Doubles slope = segment.dx * f.dy - segment.dy * f.dx;
      place_of_columns[j] = 2 * ((segment.x - f.x) * f.dy - (segment.y - f.y) * f.dx) + slope;
      Doubles width = abs(slope) + margins.across;
      where(slope == 0, width) = margins.along;
      width_of_columns[j] = width;
    }
    // Jumps that cannot be predicted would take most of the time: so pairs are remembered as bits.
    Doubles bits = 0, bit = 1;
    const auto* pair = first_of_pairs_.data();
    std::size_t remembered = 0;
    const auto visit_remembered = [&] {
      for (std::uint32_t lane = 0; lane < at_once; ++lane)
        for (auto left = static_cast<std::uint64_t>(static_cast<std::int64_t>(bits[lane]));
             left != 0; left &= left - 1) {
          const auto& [e, f] = pair[std::countr_zero(left)];
          visit(std::pair{e, f + lane});
        }
      pair += remembered;
      remembered = 0;
      bits = 0;
      bit = 1;
    };
    const Pairs* pairs = pairs_.data();
    const bool are_many = rows_.size() > few_rows;
    for (const auto& [e, low, high] : rows_) {
      if (remembered + columns_.size() > bits_of_a_double) visit_remembered();
      remembered += columns_.size();
      const double slope = e.dx * segment.dy - e.dy * segment.dx;
      const double place_of_row = 2 * (e.dx * (segment.y - e.y) - e.dy * (segment.x - e.x)) + slope;
      const double width_of_row = slope == 0 ? margins.along : std::abs(slope) + margins.across;
      if (are_many && (place_of_row - width_of_row > high || place_of_row + width_of_row < low)) {
        pairs += columns_.size();
        bit *= static_cast<double>(std::uint64_t{1} << columns_.size());
        continue;
      }
      const Doubles place = place_of_row, width = width_of_row;
      for (std::size_t j = 0; j < columns_.size(); ++j, ++pairs) {
        const Doubles beyond = max(abs(place_of_columns[j] - pairs->along_f) - width_of_columns[j],
                                   abs(place - pairs->along_e) - width);
        where(beyond < pairs->width, bits) += bit;
        bit += bit;
      }
    }
    visit_remembered();
  }

 private:
  using Doubles = std::experimental::native_simd<double>;
  static constexpr std::size_t at_once = Doubles::size();
  static constexpr std::size_t bits_of_a_double = std::numeric_limits<double>::digits;
  static constexpr std::size_t few_rows = 10;  ///< of fewer it is faster to look at all of them
  static constexpr std::size_t most_columns = bits_of_a_double - 5;

  struct Columns {
    Doubles x, y, dx, dy;  ///< of edges of Q; no numbers behind the last one
  };

  struct Row {
    NearSegment edge;  ///< of P
    double low, high;  ///< where the strips along it are
  };

  struct Pairs {
    Doubles along_f;  ///< the middle, but for what depends on f and the segment only
    Doubles along_e;  ///< likewise
    Doubles width;
  };

  ShortList<Columns> columns_;
  ShortList<Row> rows_;
  ShortList<Pairs> pairs_;  ///< row by row
  ShortList<std::pair<std::uint32_t, std::uint32_t>> first_of_pairs_;
};

}  // namespace oplus::slide
