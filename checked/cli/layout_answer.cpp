// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/layout_answer.hpp"

#include <algorithm>
#include <iostream>
#include <set>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/json_values.hpp"
#include "checked/cli/numbers.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/writing.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

namespace {

/// Exact where that is short.
std::string in_short(const Rational& value) {
  constexpr std::size_t longest = 24;
  const std::string exact = to_string(value);
  return exact.size() <= longest ? exact : "about " + approximate(value);
}

std::string in_short(const Vector& v) {
  const std::string x = in_short(v.x), y = in_short(v.y);
  const bool is_exact = x[0] != 'a' && y[0] != 'a';
  return is_exact ? "(" + x + ", " + y + ")"
                  : "about (" + approximate(v.x) + ", " + approximate(v.y) + ")";
}

std::string share(const SheetVerdict& verdict) {
  return verdict.area == 0 ? "0" : to_string(Rational(100 * verdict.used_area / verdict.area), 3);
}

/// "part 3 (item 7, line 12)"
std::string called(const Sheet& sheet, std::size_t part) {
  const PlacedPart& p = sheet.parts[part];
  return "part " + std::to_string(part + 1) + " (" +
         (p.name.empty() ? "" : one_line(p.name) + ", ") + "line " + std::to_string(p.line) + ")";
}

std::string kind(const LayoutFault& fault) {
  const bool overlaps = std::holds_alternative<OverlapFound>(fault.what);
  return fault.other ? overlaps ? "overlap" : "too near" : overlaps ? "outside" : "margin";
}

std::string line(const Sheet& sheet, const LayoutFault& fault) {
  const std::string part = called(sheet, fault.part);
  std::string text = kind(fault) + ": ";
  if (fault.other) text += called(sheet, *fault.other) + " and ";
  text += part + ": ";
  if (const auto* nearest = std::get_if<NearestPoints>(&fault.what))
    return text + "distance " + rounded_roots(nearest->squared_distance) + ", between " +
           to_string(nearest->on_p) + " and " + to_string(nearest->on_q);
  const auto& found = std::get<OverlapFound>(fault.what);
  text += to_string(found.witness) + " is inside " + (fault.other ? "both" : "the part") +
          ", area " + in_short(found.area) + ", ";
  if (!found.way_out) return text + "the part fits nowhere as it is turned";
  return text + "depth " + rounded_roots(found.way_out->squared_depth) + ": moved by " +
         in_short(found.way_out->move) + ", " + "part " + std::to_string(fault.part + 1) +
         (fault.other ? " only touches" : " is inside");
}

std::size_t forgiven(const Verdicts& verdicts) {
  std::size_t all = 0;
  for (const SheetVerdict& verdict : verdicts) all += verdict.forgiven;
  return all;
}

Json json_of(const LayoutFault& fault) {
  Json object = {{"kind", kind(fault)}};
  object["parts"] = Json::array();
  if (fault.other) object["parts"].push_back(*fault.other + 1);
  object["parts"].push_back(fault.part + 1);
  if (const auto* nearest = std::get_if<NearestPoints>(&fault.what)) {
    object["squared_distance"] = to_string(nearest->squared_distance);
    object["between"] = {json(nearest->on_p), json(nearest->on_q)};
    return object;
  }
  const auto& found = std::get<OverlapFound>(fault.what);
  object["witness"] = json(found.witness);
  object["area"] = to_string(found.area);
  if (!found.way_out) return object;
  object["squared_depth"] = to_string(found.way_out->squared_depth);
  object["move"] = json(found.way_out->move);
  return object;
}

}  // namespace

bool is_right(const Verdicts& verdicts) {
  return std::all_of(verdicts.begin(), verdicts.end(),
                     [](const SheetVerdict& verdict) { return verdict.is_right(); });
}

std::string text_answer(const Layout& layout, const Verdicts& verdicts) {
  std::size_t wrong = 0;
  for (const SheetVerdict& verdict : verdicts) wrong += verdict.faults.size();
  std::string text = wrong == 0 ? painted(Paint::good, "right", std::cout) + "\n"
                                : painted(Paint::bad, "wrong", std::cout) + ": " +
                                      counted(wrong, "fault", "faults") + "\n";
  for (std::size_t s = 0; s < verdicts.size(); ++s) {
    const Sheet& sheet = layout.sheets[s];
    const std::string name = sheet.name.empty() ? "" : sheet.name + ": ";
    for (const LayoutFault& fault : verdicts[s].faults) text += name + line(sheet, fault) + "\n";
    text += name + counted(sheet.parts.size(), "part", "parts") + ", used area " +
            in_short(verdicts[s].used_area) + ", " + share(verdicts[s]) + " % of " +
            (sheet.container ? "the container" : "the rectangle around them") + "\n";
  }
  if (forgiven(verdicts) > 0)
    text += counted(forgiven(verdicts), "overlap is", "overlaps are") + " forgiven\n";
  return text;
}

std::string json_answer(const Layout& layout, const Verdicts& verdicts) {
  Json object = {{"answer", is_right(verdicts) ? "right" : "wrong"},
                 {"forgiven", forgiven(verdicts)},
                 {"sheets", Json::array()}};
  for (std::size_t s = 0; s < verdicts.size(); ++s) {
    const Sheet& sheet = layout.sheets[s];
    Json faults = Json::array(), names = Json::array(), lines = Json::array();
    for (const LayoutFault& fault : verdicts[s].faults) faults.push_back(json_of(fault));
    for (const PlacedPart& part : sheet.parts) {
      names.push_back(one_line(part.name));
      lines.push_back(part.line);
    }
    object["sheets"].push_back({{"name", sheet.name},
                                {"parts", sheet.parts.size()},
                                {"used_area", to_string(verdicts[s].used_area)},
                                {"area", to_string(verdicts[s].area)},
                                {"density_percent", share(verdicts[s])},
                                {"faults", std::move(faults)},
                                {"names", std::move(names)},
                                {"lines", std::move(lines)}});
  }
  object["notes"] = layout.notes;
  return object.dump(2) + "\n";
}

std::string svg_answer(const Layout& layout, const Verdicts& verdicts) {
  std::vector<Panel> panels;
  for (std::size_t s = 0; s < verdicts.size(); ++s) {
    const Sheet& sheet = layout.sheets[s];
    Style wrong_part = labelled(style::summand_q, "wrong part");
    wrong_part.name = "wrong-part";
    wrong_part.line = "#b00020";
    wrong_part.fill = "#ff9a9a";
    Layer container{labelled(style::sum, "container")}, defects{labelled(style::holes, "defect")};
    Layer right{labelled(style::summand_p, "part")}, wrong{wrong_part};
    Layer witnesses{labelled(style::difference, "witness")};
    Layer gaps{labelled(style::dangling_edges, "too near")};
    if (sheet.container) container.region = *sheet.container;
    const auto add = [](Layer& layer, const Region& region) {
      layer.region = together(std::move(layer.region), region);
    };
    for (const DefectiveZone& defect : sheet.defects) add(defects, defect.region);
    std::set<std::size_t> wrong_parts;
    for (const LayoutFault& fault : verdicts[s].faults) {
      wrong_parts.insert(fault.part);
      if (fault.other) wrong_parts.insert(*fault.other);
      if (const auto* nearest = std::get_if<NearestPoints>(&fault.what))
        gaps.segments.push_back({nearest->on_p, nearest->on_q});
      else
        witnesses.points.push_back(std::get<OverlapFound>(fault.what).witness);
    }
    for (std::size_t i = 0; i < sheet.parts.size(); ++i)
      add(wrong_parts.contains(i) ? wrong : right,
          translated(*sheet.parts[i].shape, sheet.parts[i].at));
    panels.push_back({sheet.name, {container, defects, right, wrong, gaps, witnesses}});
  }
  return svg(panels, 560);
}

std::string wkt_answer(const Layout& layout, const Verdicts&) {
  std::string text;
  for (const Sheet& sheet : layout.sheets)
    for (const PlacedPart& part : sheet.parts) text += wkt(translated(*part.shape, part.at)) + "\n";
  return text;
}

std::string container_answer(const Layout& layout, const Verdicts&) {
  std::string text;
  for (const Sheet& sheet : layout.sheets) text += wkt(sheet.container.value_or(Region())) + "\n";
  return text;
}

}  // namespace oplus
