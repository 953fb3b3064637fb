// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/engine_measurement.hpp"

#include <algorithm>
#include <array>
#include <boost/functional/hash.hpp>
#include <ctime>

#include "checked/arrangement/rca.hpp"
#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "properties/experiments/repetitions.hpp"

namespace oplus {

namespace {

struct Engine {
  std::string name;
  ComputedSum (*compute)(const Summands& pair);
};

const std::array<Engine, 2>& engines() {
  static const std::array<Engine, 2> both = {{
      {"rca", [](const Summands& s) { return rca(s.p, s.q, Boundary::open); }},
      {"winding",
       [](const Summands& s) { return sum_by_winding_numbers(s.p, s.q, Boundary::open); }},
  }};
  return both;
}

const std::vector<std::string> sizes = {"segments", "vertices",   "edges",
                                        "faces",    "hole_tests", "point_tests"};
const std::vector<std::string> stages = {"cycles",    "arrangement", "hierarchy",
                                         "hole_test", "degenerate",  "output"};
const std::vector<std::string> of_pair = {"m", "n"};
const std::vector<std::string> of_sum = {"sum_chains", "sum_holes", "sum_edges", "sum_dangling",
                                         "sum_isolated"};

double without_output(const Stages& s) {
  return (s.cycles + s.arrangement + s.hierarchy + s.hole_test + s.degenerate).count();
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
  Stages stages;
  double busy;  ///< processor time / time
};

Row measured(const Engine& engine, const Summands& pair) {
  ComputedSum result;
  const auto run = [&] {
    result = {};  // before the next is computed: two sums are not what is measured
    Stages::Duration duration{};
    const std::clock_t start = std::clock();
    timed(duration, [&] { result = engine.compute(pair); });
    const double worked = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return Run{result.statistics.stages, worked / duration.count()};
  };
  std::vector<Run> runs = {run()};
  const std::size_t times = repetitions(result.statistics.arrangement_edges);
  while (runs.size() < times) runs.push_back(run());
  const auto [middle, busy] =
      median(std::move(runs), [](const Run& one) { return without_output(one.stages); });
  const RunStatistics& statistics = result.statistics;
  const MinkowskiSum& sum = result.sum;
  return {
      {"m", vertex_count(pair.p)},
      {"n", vertex_count(pair.q)},
      {"repetitions", times},
      {"busy", busy},
      {"segments", statistics.segments},
      {"vertices", statistics.arrangement_vertices},
      {"edges", statistics.arrangement_edges},
      {"faces", statistics.arrangement_faces},
      {"hole_tests", statistics.hole_tests},
      {"point_tests", statistics.point_tests},
      {"cycles", middle.cycles.count()},
      {"arrangement", middle.arrangement.count()},
      {"hierarchy", middle.hierarchy.count()},
      {"hole_test", middle.hole_test.count()},
      {"degenerate", middle.degenerate.count()},
      {"output", middle.output.count()},
      {"time", without_output(middle)},
      {"sum_chains", sum.outer.size()},
      {"sum_holes", sum.holes.size()},
      {"sum_edges", edges(sum).size()},
      {"sum_dangling", sum.dangling_edges.size()},
      {"sum_isolated", sum.isolated_vertices.size()},
      {"digest", digest(sum)},
  };
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
  for (const Engine& engine : engines()) {
    append(engine.name + '_', {"outcome", "repetitions", "busy"});
    append(engine.name + '_', sizes);
    append(engine.name + '_', stages);
    append(engine.name + '_', {"time", "peak_mb"});
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
  for (const Engine& engine : engines())
    reports.push_back(
        in_process_of_its_own([&] { return measured(engine, make()).dump(); }, memory_limit_mb));
  return row_of(reports.at(0), reports.at(1));
}

std::string fault_of(const Row& row) {
  std::string fault;
  for (const Engine& engine : engines()) {
    const std::string outcome = row.at(engine.name + "_outcome");
    if (outcome != "done" && outcome != "out of memory")
      fault += engine.name + " " + outcome + "; ";
  }
  if (row.contains("same_sum") && !row.at("same_sum").get<bool>()) fault += "the sums differ; ";
  if (!fault.empty()) fault.resize(fault.size() - 2);
  return fault;
}

bool is_complete(const Row& row) {
  return row.at("rca_outcome") == "done" && row.at("winding_outcome") == "done";
}

}  // namespace oplus
