// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/distance/distance.hpp"

#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/json_values.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/shared_options.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct PairOptions {
  std::string p;
  std::string q;
  Overlaps overlaps = Overlaps::refused;
  bool json = false;
};

Region read_part(const std::string& path, const PairOptions& options) {
  Region region = read_summand(path, nullptr, Extent::any, options.overlaps);
  if (region.components.empty()) throw InvalidInput({path, 0, 0}, "the region is empty", "a part");
  return region;
}

/// Of an answer: a squared length, and what else is to be said, each as text and in JSON.
struct Answer {
  std::string what;
  Rational squared;
  std::string text;
  Json members;
};

void write_answer(const PairOptions& options, const Answer& answer) {
  const std::string root = rounded_root(answer.squared, false);
  if (options.json) {
    Json object = {{"squared_" + answer.what, to_string(answer.squared)}, {answer.what, root}};
    object.update(answer.members);
    return write_text("-", object.dump(2) + "\n");
  }
  write_text("-", answer.what + ": " + root + "\nsquared: " + to_string(answer.squared) + "\n" +
                      answer.text);
}

template <typename Answered>
ExitCode answer(const PairOptions& options, Answered answered) {
  require_one_standard_input({options.p, options.q});
  const Region p = read_part(options.p, options);
  write_answer(options, answered(p, read_part(options.q, options)));
  return ExitCode::done;
}

ExitCode write_distance(const PairOptions& options) {
  return answer(options, [](const Region& p, const Region& q) -> Answer {
    const NearestPoints nearest = distance(p, q);
    return {
        "distance",
        nearest.squared_distance,
        "nearest: " + to_string(nearest.on_p) + " of P and " + to_string(nearest.on_q) + " of Q\n",
        {{"on_p", json(nearest.on_p)}, {"on_q", json(nearest.on_q)}}};
  });
}

ExitCode write_depth(const PairOptions& options) {
  return answer(options, [](const Region& p, const Region& q) -> Answer {
    const std::optional<Overlap> overlap = depth(p, q);
    if (!overlap)
      return {"depth", 0, "move: none, since they don't overlap\n", {{"overlap", false}}};
    return {
        "depth",
        overlap->squared_depth,
        "move: " + to_string(overlap->move) + "\ncontact: " + to_string(overlap->contact) + "\n",
        {{"overlap", true}, {"move", json(overlap->move)}, {"contact", json(overlap->contact)}}};
  });
}

void add_pair_command(Program& program, const std::string& name, const std::string& what,
                      ExitCode (*run)(const PairOptions&), const std::string& footer) {
  if (!program.needs(name)) return;
  const auto& [command, options] = program.add(name, what, run);
  command
      .file("P", options.p,
            "a region (docs/files.md), which may be unbounded (.dat); - is standard input")
      .required();
  command.file("Q", options.q, "the other one, in any of these formats").required();
  add_union(command, options.overlaps, "P, and of Q");
  command.flag("--json", options.json, "answer in JSON (docs/json.md)");
  command.footer(
      footer +
      "\n"
      "\n"
      "Example:\n"
      "  oplus gen star --n 8 --summand P -o p.wkt\n"
      "  oplus gen star --n 8 --summand Q | oplus transform - --translate 30,-20 -o q.wkt\n"
      "  oplus " +
      name + " p.wkt q.wkt");
}

}  // namespace

void add_distance(Program& program) {
  add_pair_command(program, "distance",
                   "Compute the distance of two regions, and a pair of nearest points",
                   write_distance,
                   "The squared distance and the points are exact; the distance is rounded down. "
                   "It is 0 where the\n"
                   "regions overlap or touch, and the point is one that they have in common.");
  add_pair_command(
      program, "depth", "Compute the shortest move of Q that ends its overlap with P", write_depth,
      "Moved by `move`, Q only touches P, in `contact` among other points: no shorter "
      "move is enough. The\n"
      "move may lead to an exact fit. The depth, its length, is rounded down; all else "
      "is exact.");
}

}  // namespace oplus
