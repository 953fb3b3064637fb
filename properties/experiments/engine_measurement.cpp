// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/engine_measurement.hpp"

#include <algorithm>
#include <array>
#include <boost/functional/hash.hpp>
#include <ctime>
#include <numeric>

#include "checked/engines.hpp"
#include "properties/experiments/repetitions.hpp"

namespace oplus {

namespace {

const std::array<std::string, 2> measured = {"rca", "winding"};

const std::vector<std::string> sizes = {"segments", "vertices",   "edges",
                                        "faces",    "hole_tests", "point_tests"};
const std::vector<std::string> stages = {"cycles",    "arrangement", "hierarchy",
                                         "hole_test", "degenerate",  "output"};
const std::vector<std::string> of_pair = {"m", "n"};
const std::vector<std::string> of_sum = {"sum_chains", "sum_holes", "sum_edges", "sum_dangling",
                                         "sum_isolated"};

/// In the order of `stages`; the output last.
std::vector<double> seconds_of(const Statistics& run) {
  std::vector<double> seconds;
  for (const char* stage :
       {"seconds for cycles", "seconds for the arrangement", "seconds to prepare hole tests",
        "seconds for hole tests", "seconds for low-dimensional features",
        "seconds for the canonical form"})
    seconds.push_back(run.seconds(stage).count());
  return seconds;
}

double without_output(const Statistics& run) {
  const std::vector<double> seconds = seconds_of(run);
  return std::accumulate(seconds.begin(), seconds.end() - 1, 0.0);
}

/// Tells sums apart. Not by what is written of them: that takes longer than to compute them.
std::string digest(const MinkowskiSum& sum) {
  std::size_t hash = 0;
  const auto add = [&](const Chain& chain) {
    boost::hash_combine(hash, chain.size());
    for (const Point& p : chain) {
      boost::hash_combine(hash, p.x.get_str());
      boost::hash_combine(hash, p.y.get_str());
    }
  };
  for (const auto* chains : {&sum.outer, &sum.holes}) {
    boost::hash_combine(hash, chains->size());
    for (const Chain& chain : *chains) add(chain);
  }
  boost::hash_combine(hash, sum.dangling_edges.size());
  for (const Segment& edge : sum.dangling_edges) add({edge.source, edge.target});
  add(sum.isolated_vertices);
  return std::to_string(hash);
}

struct Run {
  Statistics statistics;
  double busy;  ///< processor time / time
};

Row measurement(const Engine& engine, const Summands& pair) {
  ComputedSum result;
  const auto run = [&] {
    result = {};  // before the next is computed: two sums are not what is measured
    Seconds duration{};
    const std::clock_t start = std::clock();
    timed(duration, [&] { result = engine.compute(pair.p, pair.q, Boundary::open, {}); });
    const double worked = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return Run{result.statistics, worked / duration.count()};
  };
  std::vector<Run> runs = {run()};
  const std::size_t times = repetitions(result.statistics.count("arrangement edges"));
  while (runs.size() < times) runs.push_back(run());
  const auto [middle, busy] =
      median(std::move(runs), [](const Run& one) { return without_output(one.statistics); });
  const Statistics& statistics = result.statistics;
  const MinkowskiSum& sum = result.sum;
  Row row = {
      {"m", vertex_count(pair.p)},
      {"n", vertex_count(pair.q)},
      {"repetitions", times},
      {"busy", busy},
      {"segments", statistics.count("segments in the arrangement")},
      {"vertices", statistics.count("arrangement vertices")},
      {"edges", statistics.count("arrangement edges")},
      {"faces", statistics.count("arrangement faces")},
      {"hole_tests", statistics.count("hole tests")},
      {"point_tests", statistics.count("tests of low-dimensional features")},
      {"time", without_output(middle)},
      {"sum_chains", sum.outer.size()},
      {"sum_holes", sum.holes.size()},
      {"sum_edges", edges(sum).size()},
      {"sum_dangling", sum.dangling_edges.size()},
      {"sum_isolated", sum.isolated_vertices.size()},
      {"digest", digest(sum)},
  };
  const std::vector<double> seconds = seconds_of(middle);
  for (std::size_t i = 0; i < stages.size(); ++i) row[stages[i]] = seconds[i];
  return row;
}

void add_engine(Row& row, const std::string& name, const ProcessReport& report) {
  const bool done = report.kind == ProcessReport::Kind::done;
  row[name + "_outcome"] = done ? "done" : report.text;
  if (!done) return;
  row[name + "_peak_mb"] = report.peak_mb;
  const Row found = Row::parse(report.text);
  for (const auto* of_both : {&of_pair, &of_sum})
    for (const std::string& column : *of_both) row[column] = found.at(column);
  for (const auto* of_engine : {&sizes, &stages})
    for (const std::string& column : *of_engine) row[name + '_' + column] = found.at(column);
  for (const std::string column : {"repetitions", "busy", "time"})
    row[name + '_' + column] = found.at(column);
}

}  // namespace

std::vector<std::string> engine_columns() {
  std::vector<std::string> columns = of_pair;
  const auto append = [&](const std::string& prefix, const std::vector<std::string>& names) {
    for (const std::string& name : names) columns.push_back(prefix + name);
  };
  append("", of_sum);
  append("", {"same_sum", "ratio", "ratio_with_output"});
  for (const std::string& engine : measured) {
    append(engine + '_', {"outcome", "repetitions", "busy"});
    append(engine + '_', sizes);
    append(engine + '_', stages);
    append(engine + '_', {"time", "peak_mb"});
  }
  return columns;
}

Row row_of(const ProcessReport& rca, const ProcessReport& winding) {
  Row row = Row::object();
  add_engine(row, "rca", rca);
  add_engine(row, "winding", winding);
  if (!is_complete(row)) return row;
  row["same_sum"] = Row::parse(rca.text).at("digest") == Row::parse(winding.text).at("digest");
  const auto time = [&](const std::string& column) { return row.at(column).get<double>(); };
  row["ratio"] = time("rca_time") / time("winding_time");
  row["ratio_with_output"] =
      (time("rca_time") + time("rca_output")) / (time("winding_time") + time("winding_output"));
  return row;
}

Row measured_engines(const std::function<Summands()>& make, std::size_t memory_limit_mb) {
  std::vector<ProcessReport> reports;
  for (const std::string& name : measured)
    reports.push_back(in_process_of_its_own(
        [&] { return measurement(*find_engine(engines(), name), make()).dump(); },
        memory_limit_mb));
  return row_of(reports.at(0), reports.at(1));
}

std::string fault_of(const Row& row) {
  std::string fault;
  for (const std::string& engine : measured) {
    const std::string outcome = row.at(engine + "_outcome");
    if (outcome != "done" && outcome != "out of memory") fault += engine + " " + outcome + "; ";
  }
  if (row.contains("same_sum") && !row.at("same_sum").get<bool>()) fault += "the sums differ; ";
  if (!fault.empty()) fault.resize(fault.size() - 2);
  return fault;
}

bool is_complete(const Row& row) {
  return row.at("rca_outcome") == "done" && row.at("winding_outcome") == "done";
}

}  // namespace oplus
