// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/record.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reference/io/invalid_input.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/written.hpp"

namespace oplus {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Summands& pair) { return {{"p", wkt(pair.p)}, {"q", wkt(pair.q)}}; }

Region region_of_wkt(const Json& text, const std::string& file) {
  std::istringstream in(text.get<std::string>());
  return read_region(in, file).region;
}

std::optional<Summands> pair_of_json(const Json& object, const char* key, const std::string& file) {
  if (!object.contains(key)) return std::nullopt;
  const Json& pair = object.at(key);
  return Summands{region_of_wkt(pair.at("p"), file), region_of_wkt(pair.at("q"), file)};
}

/// A broken contract says where it stands; that moves with every edit of the file.
std::string without_place(const std::string& why) {
  return why.starts_with("threw: ") ? why.substr(0, why.find(" at ")) : why;
}

std::string lines(const std::vector<Json>& objects) {
  std::string text = "[\n";
  for (const Json& object : objects)
    text += object.dump() + (&object == &objects.back() ? "\n" : ",\n");
  return text + "]\n";
}

template <typename Value>
std::vector<Value> all_of_json(const std::string& text, const std::string& file,
                               const std::function<Value(const Json&)>& value_of) {
  try {
    std::vector<Value> values;
    for (const Json& object : Json::parse(text)) values.push_back(value_of(object));
    return values;
  } catch (const nlohmann::json::exception& e) {
    throw InvalidInput({file, 1, 0}, e.what(), "a record that oplus-check wrote");
  }
}

}  // namespace

RecordedRun recorded(const Statement& statement, const PropertyRun& run) {
  RecordedRun record{.statement = statement.id,
                     .run = run.run,
                     .discarded = run.discarded,
                     .families = run.families,
                     .classes = run.classes,
                     .counts = run.counts,
                     .typical = run.typical};
  if (run.enumeration) record.enumerated = run.enumeration->cases;
  return record;
}

std::string to_json(const std::vector<RecordedRun>& runs) {
  std::vector<Json> objects;
  for (const RecordedRun& run : runs) {
    Json object = {{"statement", run.statement}};
    if (run.enumerated) object["enumerated"] = *run.enumerated;
    object["run"] = run.run;
    object["discarded"] = run.discarded;
    object["families"] = run.families;
    object["classes"] = run.classes;
    object["counts"] = run.counts;
    if (run.typical) object["typical"] = to_json(*run.typical);
    objects.push_back(std::move(object));
  }
  return lines(objects);
}

std::string to_json(const std::vector<Kill>& kills) {
  std::vector<Json> objects;
  for (const Kill& kill : kills) {
    Json object = {{"mutant", kill.mutant}, {"statement", kill.statement},
                   {"killed", kill.killed}, {"by_enumeration", kill.by_enumeration},
                   {"cases", kill.cases},   {"why", without_place(kill.why)}};
    if (kill.shrunk) object["shrunk"] = to_json(*kill.shrunk);
    objects.push_back(std::move(object));
  }
  return lines(objects);
}

std::vector<RecordedRun> runs_of_json(const std::string& text, const std::string& file) {
  return all_of_json<RecordedRun>(text, file, [&](const Json& object) {
    RecordedRun run;
    object.at("statement").get_to(run.statement);
    if (object.contains("enumerated")) run.enumerated = object.at("enumerated").get<std::size_t>();
    object.at("run").get_to(run.run);
    object.at("discarded").get_to(run.discarded);
    object.at("families").get_to(run.families);
    object.at("classes").get_to(run.classes);
    object.at("counts").get_to(run.counts);
    run.typical = pair_of_json(object, "typical", file);
    return run;
  });
}

std::vector<Kill> kills_of_json(const std::string& text, const std::string& file) {
  return all_of_json<Kill>(text, file, [&](const Json& object) {
    Kill kill;
    object.at("mutant").get_to(kill.mutant);
    object.at("statement").get_to(kill.statement);
    object.at("killed").get_to(kill.killed);
    object.at("by_enumeration").get_to(kill.by_enumeration);
    object.at("cases").get_to(kill.cases);
    object.at("why").get_to(kill.why);
    kill.shrunk = pair_of_json(object, "shrunk", file);
    return kill;
  });
}

}  // namespace oplus
