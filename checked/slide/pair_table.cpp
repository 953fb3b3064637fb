// SPDX-License-Identifier: MIT
#include "checked/slide/pair_table.hpp"

#include <limits>

// Compiled twice where the loader can choose: processors with AVX2 take four pairs at once. Without its fused
// operations, so that both compute the same.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__)
#define OPLUS_ALSO_WITH_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define OPLUS_ALSO_WITH_AVX2
#endif

namespace oplus::slide {

PairTable::PairTable(std::span<const NearSegment> of_p, std::span<const NearSegment> of_q,
                     std::size_t most) {
  if (of_p.size() * of_q.size() > most || of_q.size() > most_columns * at_once ||
      of_p.size() > most_rows)
    return;
  columns_ = at_once_each(of_q);
  edges_of_rows_ = at_once_each(of_p);
  pairs_.resize(of_p.size() * columns_.size(), boost::container::default_init);
  fill(of_p, columns_, pairs_.data());
  rows_.reserve(of_p.size());
  for (std::size_t i = 0; i < of_p.size(); ++i) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t j = 0; j < columns_.size() && of_p.size() > few_rows; ++j) {
      const Pairs& pairs = pairs_[i * columns_.size() + j];
      for (std::size_t lane = 0; lane < at_once; ++lane) {
        low = std::min(low, pairs.along_e[lane] - pairs.width[lane]);
        high = std::max(high, pairs.along_e[lane] + pairs.width[lane]);
      }
    }
    rows_.push_back({low, high});
  }
}

auto PairTable::at_once_each(std::span<const NearSegment> edges) -> ShortList<EdgesAtOnce> {
  ShortList<EdgesAtOnce> result;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < edges.size(); i += at_once) {
    const auto fill = [&](Doubles& all, double NearSegment::*member) {
      const auto of = [&](std::size_t k) { return k < edges.size() ? edges[k].*member : none; };
      all = Doubles{of(i), of(i + 1), of(i + 2), of(i + 3)};
    };
    EdgesAtOnce& next = result.emplace_back();
    fill(next.x, &NearSegment::x);
    fill(next.y, &NearSegment::y);
    fill(next.dx, &NearSegment::dx);
    fill(next.dy, &NearSegment::dy);
  }
  return result;
}

OPLUS_ALSO_WITH_AVX2 void PairTable::fill(std::span<const NearSegment> edges,
                                          const ShortList<EdgesAtOnce>& columns, Pairs* pairs) {
  const EdgesAtOnce* const first = columns.data();
  const std::size_t count = columns.size();
  for (const NearSegment& e : edges)
    for (std::size_t j = 0; j < count; ++j, ++pairs) {
      const EdgesAtOnce& f = first[j];
      const Doubles area = e.dx * f.dy - e.dy * f.dx;
      pairs->along_f = 2 * (e.x * f.dy - e.y * f.dx) + area;
      pairs->along_e = 2 * (e.dx * f.y - e.dy * f.x) + area;
      pairs->width = area < 0 ? -area : area;
    }
}

OPLUS_ALSO_WITH_AVX2 void PairTable::find_across(const NearSegment& segment, const Margins& margins,
                                                 const EdgesAtOnce* edges, std::size_t count,
                                                 Doubles* middles, Doubles* widths) {
  for (std::size_t i = 0; i < count; ++i) {
    const EdgesAtOnce& f = edges[i];
    const Doubles slope = segment.dx * f.dy - segment.dy * f.dx;
    const Doubles across = (slope < 0 ? -slope : slope) + margins.across;
    const Doubles along = margins.along - Doubles{};
    widths[i] = slope == 0 ? along : across;
    middles[i] = 2 * ((segment.x - f.x) * f.dy - (segment.y - f.y) * f.dx) + slope;
  }
}

OPLUS_ALSO_WITH_AVX2 void PairTable::find_met(std::uint32_t row, std::uint32_t end,
                                              const Doubles* middles_of_columns,
                                              const Doubles* widths_of_columns,
                                              const Doubles* middles_of_rows,
                                              const Doubles* widths_of_rows, Bits& met) const {
  const std::size_t columns = columns_.size();
  const Pairs* pairs = pairs_.data() + row * columns;
  const bool are_many = rows_.size() > few_rows;
  // Of how far a number is from 0.
  constexpr std::int64_t but_sign = std::numeric_limits<std::int64_t>::max();
  Bits found{}, bit = Bits{} + 1;
  for (; row < end; ++row) {
    const double middle = -middles_of_rows[row / at_once][row % at_once];
    const double width = widths_of_rows[row / at_once][row % at_once];
    if (are_many && (middle - width > rows_[row].high || middle + width < rows_[row].low)) {
      pairs += columns;
      bit <<= columns;
      continue;
    }
    for (std::size_t j = 0; j < columns; ++j, ++pairs) {
      const Doubles off_f = middles_of_columns[j] - pairs->along_f, off_e = middle - pairs->along_e;
      const Doubles from_f = reinterpret_cast<Doubles>(reinterpret_cast<Bits>(off_f) & but_sign);
      const Doubles from_e = reinterpret_cast<Doubles>(reinterpret_cast<Bits>(off_e) & but_sign);
      found |=
          (from_f - widths_of_columns[j] < pairs->width) & (from_e - width < pairs->width) & bit;
      bit <<= 1;
    }
  }
  met = found;
}

}  // namespace oplus::slide
