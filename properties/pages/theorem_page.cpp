// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/theorem_page.hpp"

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <optional>
#include <set>

#include "checked/arrangement/rca.hpp"
#include "properties/pages/links.hpp"
#include "properties/pages/strength.hpp"
#include "properties/runner/registry.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/io/writing.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

namespace {

std::string link(const std::string& text, const std::string& to) {
  return "[" + text + "](" + to + ")";
}

std::string link_to_source(const std::string& file) {
  return link("`" + file + "`", "../../" + file);
}

std::string list_of_statements(const std::vector<std::string>& ids, const std::string& none) {
  std::string list;
  for (const std::string& id : ids) list += (list.empty() ? "" : ", ") + link(id, id + ".md");
  return list.empty() ? none : list;
}

/// A line with links to the algorithms' pages that cite the statement; empty where none does.
std::string citations(const Registry& registry, const std::string& id) {
  const auto found = registry.citing.find(id);
  if (found == registry.citing.end()) return {};
  std::string list;
  for (const std::string& page : found->second)
    list += (list.empty() ? "" : ", ") + link(page, "../" + page + ".md");
  return "\nCited by: " + list + ".\n";
}

std::vector<std::string> resting_on(const Registry& registry, const std::string& id) {
  std::vector<std::string> above;
  for (const Statement& s : registry.statements)
    if (std::ranges::find(s.rests_on, id) != s.rests_on.end()) above.push_back(s.id);
  return above;
}

std::string source_of_theory(const Statement& s) {
  std::string kind = s.kind();
  if (kind == "fact") return "A fact that is not in the thesis";
  if (kind == "step") return "A step of [slide](../slide.md), not in the thesis";
  if (kind == "law") return "A law of the sum that every engine must obey, not in the thesis";
  const std::string number = s.id.substr(kind.size() + 1);
  kind[0] = static_cast<char>(kind[0] - 'a' + 'A');
  return kind + " " + number + " of the thesis";
}

std::string tally(const std::string& title, const std::map<std::string, std::size_t>& counts,
                  std::size_t of, const std::vector<Promise>& promises) {
  if (counts.empty()) return {};
  std::string text = "\n| " + title + " | number |";
  text += of > 0 ? " share | promised |\n|---|---:|---:|---:|\n" : "\n|---|---:|\n";
  for (const auto& [name, count] : counts) {
    text += "| " + name + " | " + std::to_string(count) + " |";
    if (of > 0) {
      const auto promise = std::ranges::find(promises, name, &Promise::classification);
      text += " " + std::to_string(100 * count / of) + " % | " +
              (promise == promises.end() ? "" : std::to_string(promise->percent) + " %") + " |";
    }
    text += '\n';
  }
  return text;
}

std::string recorded_run(const Statement& s, const PropertyRun& run) {
  std::string text = "\n## A recorded run\n";
  text += "    oplus-check properties --theorem " + s.id + "\n";
  if (run.enumeration)
    text += "\nProved by enumeration, " + std::to_string(run.enumeration->cases) + " cases.\n";
  if (!s.check) return text;
  text += "\n" + std::to_string(run.run) + " pairs hold, " + std::to_string(run.discarded) +
          " were discarded, none failed.\n";
  text += tally("family", run.families, run.run, {});
  text += tally("pairs with", run.classes, run.run, s.promises);
  text += tally("looked at", run.counts, 0, {});
  return text;
}

std::string indented(const std::string& lines) {
  return "    " + boost::algorithm::replace_all_copy(lines, "\n", "\n    ");
}

std::string proofs(const Registry& registry, const Statement& s) {
  std::string text;
  for (const ProvedTheorem& theorem : registry.theorems) {
    if (theorem.statement != s.id) continue;
    text += "\n`" + theorem.name + "`, " + link_to_source("properties/proofs/" + theorem.file) +
            (theorem.is_whole ? "" : ", a part") + ".\n" + theorem.gloss + "\n\n" +
            indented(theorem.formal) + "\n\n- covered: " + theorem.covers +
            "\n- not covered: " + theorem.not_covered + '\n';
  }
  return text.empty()
             ? text
             : "\n## Checked by Coq\n`ctest -L proofs` checks the proofs again, and that they use "
               "no axioms.\n" +
                   text;
}

std::string answers(const Registry& registry, const Statement& s) {
  std::string text;
  for (const AnsweredQuery& query : registry.queries) {
    if (query.statement != s.id) continue;
    text += "\n`" + query.id + "`, " + link_to_source(query.file) + ": if\n";
    for (const auto& [says, counterexample] : query.hypotheses)
      text += "- " + says + "; false without: " + counterexample + '\n';
    text += "\nthen " + query.conclusion + ".\n";
  }
  return text.empty()
             ? text
             : "\n## Proved by Z3 and cvc5\nEach query is proved for all real numbers by both "
               "solvers: see [proofs by SMT](../smt.md). Behind each hypothesis stands Z3's "
               "counterexample to the statement without it, which is also one by the definitions.\n" +
                   text;
}

const Mutant& mutant_of(const Registry& registry, const std::string& name) {
  return *std::ranges::find(registry.mutants, name, &Mutant::name);
}

std::string kill_table(const Registry& registry, const std::vector<const Kill*>& kills) {
  std::string text =
      "\n## Faults that it finds\nEach changes one line of the code, in builds of the preset "
      "`check` only.\n\n| mutant | what goes wrong | where | found by |\n|---|---|---|---|\n";
  for (const Kill* kill : kills) {
    const Mutant& mutant = mutant_of(registry, kill->mutant);
    text +=
        "| `" + mutant.name + "` | " + mutant.what + " | " + link_to_source(mutant.file) + " | " +
        (kill->by_enumeration ? "the enumeration" : "case " + std::to_string(kill->cases)) + " |\n";
  }
  return text;
}

/// P, Q, and their convolution over the sum of the open regions, as SVG; there a point is marked.
std::string picture_of_pair(const Summands& pair, const std::optional<Point>& marked = {}) {
  std::vector<Layer> layers = layers_of(rca(pair.p, pair.q, Boundary::open).sum);
  // Over the region, below dangling edges and isolated vertices.
  const auto above_region = std::find_if_not(layers.begin(), layers.end(), [](const Layer& layer) {
    return !layer.region.components.empty();
  });
  layers.insert(above_region, {style::convolution, {}, segments(convolution(pair.p, pair.q))});
  if (marked)
    layers.push_back({labelled(style::difference, "where the statement fails"), {}, {}, {*marked}});
  return svg({panel_of(Summand::P, pair.p),
              panel_of(Summand::Q, pair.q),
              {"Convolution and open sum", std::move(layers)}});
}

}  // namespace

std::vector<Page> theorem_pages(const Registry& registry, const Statement& s) {
  const PropertyRun& run = registry.runs.at(s.id);
  std::vector<const Kill*> kills;
  for (const Kill& kill : registry.kills)
    if (kill.statement == s.id) kills.push_back(&kill);
  std::set<std::string> protects;
  for (const Kill* kill : kills) protects.insert(mutant_of(registry, kill->mutant).file);

  const auto linked = [&](const std::string& words) {
    return with_links_to_findings(words, registry.findings);
  };
  std::string text =
      "# " + s.title + "\n" + source_of_theory(s) + ", `" + s.id +
      "`. Words and symbols: [notation](../notation.md). Generated from the sources by "
      "`oplus-maintain pages`.\n\n## Statement\n" +
      linked(s.statement) + "\n\n## Why it holds\n" + linked(s.why) + "\n\n## Hypotheses\n";
  for (const std::string& hypothesis : s.hypotheses) text += "- " + hypothesis + '\n';
  text += "\nRests on: " + list_of_statements(s.rests_on, "definitions only") + ".\n";
  text += "\nWhat rests on it: " + list_of_statements(resting_on(registry, s.id), "nothing") +
          ". All of this: [the graph](graph.md).\n";
  text += citations(registry, s.id);
  text += "\n## How it is backed\n- " + backing(registry, s) +
          "\n- the property: " + link_to_source(relative_file(s)) + "\n- what it protects: ";
  for (const std::string& file : protects)
    text += (file == *protects.begin() ? "" : ", ") + link_to_source(file);
  text += '\n' + proofs(registry, s) + answers(registry, s) + recorded_run(s, run) +
          kill_table(registry, kills);

  std::vector<Page> pages;
  if (run.typical) {
    const std::string picture = "pictures/" + s.id + "-typical.svg";
    text +=
        "\n## A typical case\nThe median by size of the pairs of the run.\n\n![P, Q, and their convolution and open sum](" +
        picture + ")\n";
    pages.push_back({"theorems/" + picture, picture_of_pair(*run.typical)});
  }
  const auto shown =
      std::ranges::find_if(kills, [](const Kill* kill) { return kill->shrunk.has_value(); });
  if (shown != kills.end()) {
    const Kill& kill = **shown;
    const std::string picture = "pictures/" + s.id + "-shrunk.svg";
    text += "\n## A shrunk counterexample\nWith the fault `" + kill.mutant +
            "` the statement fails on this pair, and on no smaller one; without the fault it "
            "holds.\nWhat is seen: " +
            kill.why + ".\n\n    P: " + wkt(kill.shrunk->p) + "\n    Q: " + wkt(kill.shrunk->q) +
            "\n\n![P, Q, and their convolution and open sum](" + picture + ")\n";
    pages.push_back({"theorems/" + picture, picture_of_pair(*kill.shrunk, kill.at)});
  }
  pages.push_back({"theorems/" + s.id + ".md", std::move(text)});
  return pages;
}

}  // namespace oplus
