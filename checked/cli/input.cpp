// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/input.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>

#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/operations/union_of.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/invalid_region.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

/// Shows how far the reading of a file is, and takes the times.
class WatchedReading {
 public:
  WatchedReading(const std::string& path, ReadingTimes* times)
      : name_(path == "-" ? "standard input" : one_line(path)),
        step_("reading " + name_),
        times_(times),
        start_(Clock::now()) {}
  WatchedReading(const WatchedReading&) = delete;
  WatchedReading& operator=(const WatchedReading&) = delete;

  /// What follows when all is parsed is the validity check.
  ~WatchedReading() {
    if (times_ != nullptr && parsed_) times_->validation += Clock::now() - *parsed_;
  }

  /// What reading is to call.
  ReadingProgress progress() {
    return [this](int percent) {
      if (percent < 100) return step_.advance(static_cast<std::size_t>(percent), 100);
      step_.next("checking " + name_);
      parsed_ = Clock::now();
      if (times_ != nullptr) times_->reading += *parsed_ - start_;
    };
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string name_;
  ShownStep step_;
  ReadingTimes* times_;
  Clock::time_point start_;
  std::optional<Clock::time_point> parsed_;
};

/// Names --union where components that overlap are refused; all commands that read a summand have it.
template <typename Read>
auto naming_union(Read read) {
  try {
    return read();
  } catch (const OverlappingComponents& error) {
    throw UsageError(std::string(error.what()) + "; " + hint_at_union);
  }
}

/// What is read from a file, after its notes are said.
template <typename Read>
auto said(const std::string& path, ReadingTimes* times, Read read) {
  const auto read_watched = [&] {
    WatchedReading watched(path, times);
    return read(watched.progress());
  };
  auto result = read_watched();
  for (const std::string& note : result.notes) say_note(note);
  return result;
}

}  // namespace

Region read_summand(const std::string& path, ReadingTimes* times, Extent extent,
                    Overlaps overlaps) {
  return said(path, times,
              [&](const ReadingProgress& progress) {
                ReadRegion read = naming_union(
                    [&] { return read_region_file(path, progress, extent, overlaps); });
                unite(read.region, overlaps);
                return read;
              })
      .region;
}

ReadSet read_summand_set(const std::string& path, ReadingTimes* times, Overlaps overlaps) {
  return said(path, times, [&](const ReadingProgress& progress) {
    ReadSet read = naming_union([&] { return read_set_file(path, progress, overlaps); });
    unite(read.region, overlaps);
    return read;
  });
}

void unite(Region& region, Overlaps overlaps) {
  if (overlaps == Overlaps::allowed) region = region_of(union_of(region));
}

bool is_region(const ReadSet& set) { return set.segments.empty() && set.points.empty(); }

PlanarSet union_in(const ReadSet& set) { return union_of(set.region, set.segments, set.points); }

PlanarSet result_of(const Operation& operation, const ReadSet& p, const ReadSet& q,
                    const SumOf& sum) {
  return is_region(p) && is_region(q) ? operation.compute(p.region, q.region, sum)
                                      : operation.compute_of_sets(union_in(p), union_in(q), sum);
}

PlanarSet set_in(const ReadSet& read) {
  BoundaryFeatures features{{}, {}, read.points};
  std::set<Point> ends;
  for (const Segment& s : read.segments) {
    if (s.source == s.target) continue;
    features.dangling_edges.push_back(s);
    ends.insert({s.source, s.target});
  }
  // A line string may repeat a vertex; one that does nothing else is a point.
  for (const Segment& s : read.segments)
    if (s.source == s.target && !ends.contains(s.source))
      features.isolated_vertices.push_back(s.source);
  PlanarSet set = canonical_sum(read.region), low = canonical_sum(features);
  set.dangling_edges = std::move(low.dangling_edges);
  set.isolated_vertices = std::move(low.isolated_vertices);
  return set;
}

PlanarSet read_canonical_sum(const std::string& path) {
  return said(path, nullptr,
              [&](const ReadingProgress& progress) { return read_sum_file(path, progress); })
      .sum;
}

ClaimedSum read_unchecked_sum(const std::string& path) {
  return read_unchecked_sum_file(path, WatchedReading(path, nullptr).progress());
}

UncheckedInput read_unchecked_region(const std::string& path) {
  return said(path, nullptr,
              [&](const ReadingProgress& progress) { return read_unchecked_file(path, progress); });
}

void require_one_standard_input(const std::vector<std::string>& paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1)
    throw UsageError("standard input (-) can be read only once; give the others as files");
}

}  // namespace oplus
