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

  /// Empty where there are more pairs than `most` or more edges than fit.
  template <typename Edges>
  PairTable(const Edges& of_p, const Edges& of_q, std::size_t most) {
    if (of_p.size() * of_q.size() > most || of_q.size() > most_columns * at_once ||
        of_p.size() > most_rows)
      return;
    columns_ = at_once_each(of_q);
    edges_of_rows_ = at_once_each(of_p);
    for (const NearSegment& e : of_p) {
      const auto row = static_cast<std::uint32_t>(rows_.size());
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::uint32_t j = 0; j < columns_.size(); ++j) {
        const EdgesAtOnce& f = columns_[j];
        const Doubles area = e.dx * f.dy - e.dy * f.dx;
        pairs_.push_back({2 * (e.x * f.dy - e.y * f.dx) + area,
                          2 * (e.dx * f.y - e.dy * f.x) + area, abs(area)});
        first_of_pairs_.emplace_back(row, j * static_cast<std::uint32_t>(at_once));
        if (of_p.size() <= few_rows) continue;
        const Pairs& pairs = pairs_.back();
        for (std::size_t lane = 0; lane < at_once; ++lane) {
          low = std::min(low, pairs.along_e[lane] - pairs.width[lane]);
          high = std::max(high, pairs.along_e[lane] + pairs.width[lane]);
        }
      }
      rows_.push_back({low, high});
    }
  }

  bool is_empty() const { return rows_.empty(); }

  /// Visits the numbers of all pairs of edges whose parallelogram a segment meets or is nearer to than
  /// the margins, and of some others.
  template <typename Visit>
  void each_near(const NearSegment& segment, const Margins& margins, const Visit& visit) const {
    std::array<Doubles, most_columns> place_of_columns, width_of_columns;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const EdgesAtOnce& f = columns_[j];
      place_of_columns[j] = twice_the_middle(segment, f, width_of_columns[j], margins);
    }
    std::array<double, most_rows> place_of_rows, width_of_rows;
    for (std::size_t i = 0; i < edges_of_rows_.size(); ++i) {
      Doubles width;
      const Doubles place = -twice_the_middle(segment, edges_of_rows_[i], width, margins);
      place.copy_to(&place_of_rows[i * at_once], std::experimental::element_aligned);
      width.copy_to(&width_of_rows[i * at_once], std::experimental::element_aligned);
    }
    // Jumps that cannot be predicted would take most of the time: so pairs are remembered as bits.
    Doubles bits = 0, bit = 1;
    const auto* first = first_of_pairs_.data();
    const auto visit_remembered = [&visit](const Doubles& remembered, const auto* pair) {
      for (std::uint32_t lane = 0; lane < at_once; ++lane)
        for (auto left = static_cast<std::uint64_t>(static_cast<std::int64_t>(remembered[lane]));
             left != 0; left &= left - 1) {
          const auto& [e, f] = pair[std::countr_zero(left)];
          visit(std::pair{e, f + lane});
        }
    };
    std::size_t remembered = 0;
    const Pairs* pairs = pairs_.data();
    const std::size_t columns = columns_.size();
    const bool are_many = rows_.size() > few_rows;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (remembered + columns > bits_of_a_double) {
        visit_remembered(bits, first);
        first += remembered;
        remembered = 0;
        bits = 0;
        bit = 1;
      }
      remembered += columns;
      if (are_many && (place_of_rows[i] - width_of_rows[i] > rows_[i].high ||
                       place_of_rows[i] + width_of_rows[i] < rows_[i].low)) {
        pairs += columns;
        bit *= static_cast<double>(std::uint64_t{1} << columns);
        continue;
      }
      const Doubles place = place_of_rows[i], width = width_of_rows[i];
      for (std::size_t j = 0; j < columns; ++j, ++pairs) {
        const Doubles beyond = max(abs(place_of_columns[j] - pairs->along_f) - width_of_columns[j],
                                   abs(place - pairs->along_e) - width);
        Doubles met = 0;
        where(beyond < pairs->width, met) = bit;
        bits += met;
        bit += bit;
      }
    }
    visit_remembered(bits, first);
  }

 private:
  using Doubles = std::experimental::native_simd<double>;
  static constexpr std::size_t at_once = Doubles::size();
  static constexpr std::size_t bits_of_a_double = std::numeric_limits<double>::digits;
  static constexpr std::size_t few_rows = 10;  ///< of fewer it is faster to look at all of them
  static constexpr std::size_t most_columns = bits_of_a_double - 5;
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

  template <typename Edges>
  static ShortList<EdgesAtOnce> at_once_each(const Edges& edges) {
    ShortList<EdgesAtOnce> result;
    for (std::size_t i = 0; i < edges.size(); i += at_once) {
      const auto all = [&](auto member) {
        return Doubles([&](auto lane) {
          return i + lane < edges.size() ? edges[i + lane].*member
                                         : std::numeric_limits<double>::quiet_NaN();
        });
      };
      result.push_back({all(&NearSegment::x), all(&NearSegment::y), all(&NearSegment::dx),
                        all(&NearSegment::dy)});
    }
    return result;
  }

  /// How far the middle of a segment is across strips along edges, from where these start; and, as
  /// `width`, how far it reaches from there.
  [[gnu::always_inline]] static Doubles twice_the_middle(const NearSegment& segment,
                                                         const EdgesAtOnce& edges, Doubles& width,
                                                         const Margins& margins) {
    const Doubles slope = segment.dx * edges.dy - segment.dy * edges.dx;
    width = abs(slope) + margins.across;
    where(slope == 0, width) = margins.along;
    return 2 * ((segment.x - edges.x) * edges.dy - (segment.y - edges.y) * edges.dx) + slope;
  }

  ShortList<EdgesAtOnce> columns_;        ///< of Q
  ShortList<EdgesAtOnce> edges_of_rows_;  ///< of P
  ShortList<Row> rows_;                   ///< edge by edge of P
  ShortList<Pairs> pairs_;                ///< row by row
  ShortList<std::pair<std::uint32_t, std::uint32_t>> first_of_pairs_;
};

}  // namespace oplus::slide
