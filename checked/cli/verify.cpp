// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/verify.hpp"

#include <optional>
#include <utility>

#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/json_values.hpp"
#include "checked/cli/layer_styles.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/view.hpp"
#include "checked/verify/closeness.hpp"
#include "checked/verify/verdict_text.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct VerifyOptions {
  std::string p;
  std::string q;
  std::string sum;
  Overlaps overlaps = Overlaps::refused;
  Boundary boundary = Boundary::closed;
  std::optional<std::string> tolerance;
  std::optional<std::string> svg;
  bool json = false;
};

std::string text_of(const Closeness& close, const std::string& tolerance) {
  std::string text = close.is_close() ? "yes: " : "no: ";
  if (close.is_close() && !close.has_same_chains()) {
    text += "the sets differ only within " + tolerance + " of the boundary of the sum\n";
  } else {
    text += "the boundaries are ";
    text += close.is_within ? "within " : "not within ";
    text += tolerance + " of each other\n";
  }
  if (close.distance) {
    text +=
        (close.is_distance_of_given() ? "distance of the boundary of S from it: " : "distance: ") +
        rounded_roots(close.distance->least_squared, close.distance->most_squared);
    if (sign(close.distance->most_squared) > 0)
      text += std::string(", at ") + to_string(close.distance->farthest) + " of the boundary of " +
              (close.distance->farthest_is_given ? "S" : "the sum");
    text += "\n";
  }
  text += close.no_partners.empty() ? "components and holes correspond\n" : "";
  for (const std::string& line : close.no_partners)
    text += line + (close.is_close() ? ", which this tolerance allows\n" : "\n");
  return text;
}

Json json_of(const Verdict& verdict) {
  Json reasons = Json::array();
  for (const Reason& reason : verdict.reasons)
    reasons.push_back({{"kind", describe(reason.kind)},
                       {"detail", reason.detail},
                       {"witness", json(reason.witness)},
                       {"in_sum", reason.in_sum},
                       {"given", reason.in_given}});
  Json result = {{"answer", verdict.is_sum() ? "yes" : "no"}, {"reasons", std::move(reasons)}};
  if (!verdict.is_sum()) result["witness"] = json(verdict.reasons.front().witness);
  if (verdict.addends) {
    result["p"] = json(verdict.addends->p);
    result["q"] = json(verdict.addends->q);
  }
  return result;
}

Json json_of(const Closeness& close, const Rational& tolerance) {
  Json result = {
      {"answer", close.is_close() ? "yes" : "no"},
      {"tolerance", to_string(tolerance)},
      {"within", close.is_within},
      {"differs_near_boundary_only", close.has_same_chains() || close.differs_near_boundary_only},
      {"without_partner", close.no_partners}};
  if (!close.distance) {
    result["distance"] = nullptr;
    return result;
  }
  const BoundaryDistance& d = *close.distance;
  result["distance"] = {{"at_least", rounded_root(d.least_squared, false)},
                        {"at_most", rounded_root(d.most_squared, true)},
                        {"squared_at_least", to_string(d.least_squared)},
                        {"squared_at_most", to_string(d.most_squared)},
                        {"at", json(d.farthest)},
                        {"of", d.farthest_is_given ? "given" : "sum"}};
  return result;
}

/// The given chains over the sum; at the witness P and -Q + x.
std::string picture(const Region& p, const Region& q, const ClaimedSum& given,
                    const PlanarSet& right, const std::optional<Point>& witness) {
  std::vector<Layer> layers = layers_of(right);
  Layer chains{labelled(style::boundary_loop, "S")};
  chains.segments = edges(given.region);
  std::erase_if(chains.segments, [](const Segment& e) { return e.source == e.target; });
  chains.segments.insert(chains.segments.end(), given.dangling_edges.begin(),
                         given.dangling_edges.end());
  layers.push_back(std::move(chains));
  layers.push_back({labelled(style::touching, "point of S"), {}, {}, given.isolated_vertices});
  if (witness) layers.push_back({labelled(style::difference, "witness"), {}, {}, {*witness}});
  std::vector<std::vector<Panel>> columns = {{panel_of(Summand::P, p), panel_of(Summand::Q, q)},
                                             {{"S over P \u2295 Q", layers}}};
  if (witness) columns.push_back({placement_panel(p, q, *witness)});
  return svg_in_columns(columns, 420);
}

/// Prints the answer, writes the picture if there is one, and returns the exit code.
ExitCode answer(const VerifyOptions& options, bool is_yes, Json json, std::string text,
                const std::vector<std::string>& notes, std::vector<OutputTo> outputs) {
  json["boundary"] = name(options.boundary);
  json["notes"] = notes;
  for (const std::string& note : notes) text += "note: " + note + "\n";
  outputs.emplace_back("-", options.json ? json.dump(2) + "\n" : std::move(text));
  write_texts(outputs);
  return is_yes ? ExitCode::done : ExitCode::not_equal;
}

ExitCode verify_files(const VerifyOptions& options) {
  require_one_standard_input({options.p, options.q, options.sum});
  require_writable({}, options.svg);
  const std::optional<Rational> tolerance =
      options.tolerance ? std::optional(distance_number("--tolerance", *options.tolerance))
                        : std::nullopt;
  const Region p = read_summand(options.p, nullptr, Extent::bounded, options.overlaps);
  const Region q = read_summand(options.q, nullptr, Extent::bounded, options.overlaps);
  const ClaimedSum given = read_unchecked_sum(options.sum);
  const auto drawn = [&](const PlanarSet& right, const std::optional<Point>& witness) {
    std::vector<OutputTo> outputs;
    if (options.svg) outputs.emplace_back(*options.svg, picture(p, q, given, right, witness));
    return outputs;
  };

  if (tolerance) {
    const PlanarSet right = sum_by_definition(p, q, options.boundary);
    const Closeness close = closeness(right, given, *tolerance);
    const bool differs = close.distance && sign(close.distance->most_squared) > 0;
    return answer(options, close.is_close(), json_of(close, *tolerance),
                  text_of(close, *options.tolerance), close.notes,
                  drawn(right, differs ? std::optional(close.distance->farthest) : std::nullopt));
  }
  const Verdict verdict = verify(p, q, options.boundary, given);
  return answer(
      options, verdict.is_sum(), json_of(verdict), text_of(verdict), verdict.notes,
      drawn(verdict.right,
            verdict.is_sum() ? std::nullopt : std::optional(verdict.reasons.front().witness)));
}

}  // namespace

void add_verify(Program& program) {
  const auto& [command, options] = program.add(
      "verify",
      "Check whether a set is the sum of two regions; if not, give a witness and the reason",
      verify_files);
  command.file("P", options.p, "a region (docs/files.md); - is standard input").required();
  command.file("Q", options.q, "the other region").required();
  command.file("S", options.sum, "the sum to check, valid or not").required();
  add_union(command, options.overlaps, "P, and of Q");
  add_open(command, options.boundary,
           "check it against the sum of the regions' interiors, with dangling edges and isolated "
           "vertices");
  command.option(
      "--tolerance D", options.tolerance,
      "for a rounded sum: check that it differs from the sum only within the distance D of the "
      "sum's boundary, and say which components and holes do not correspond");
  command.file("--svg", options.svg, "draw S over the sum, and P and -Q + x at the witness x");
  command.flag("--json", options.json, "answer in JSON (docs/json.md)");
  command.footer(
      "Example:\n"
      "  oplus gen tight --n 6 --summand P -o p.wkt\n"
      "  oplus gen tight --n 6 --summand Q -o q.wkt\n"
      "  oplus sum p.wkt q.wkt --grid 0.01 -o s.wkt\n"
      "  oplus sum p.wkt q.wkt -o exact.wkt\n"
      "  oplus verify p.wkt q.wkt exact.wkt\n"
      "  oplus verify p.wkt q.wkt s.wkt --tolerance 0.01\n"
      "\n"
      "Exit codes:\n"
      "  0  it is their sum\n"
      "  1  it is not");
}

}  // namespace oplus
