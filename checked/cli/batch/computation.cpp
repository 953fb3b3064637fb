// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/computation.hpp"

#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "checked/cli/input.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/operations/complement.hpp"
#include "checked/rounding/rounding.hpp"
#include "checked/slide/by_slide.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr const char* no_fit_name = "nfp";
constexpr const char* of_a_bug = "a bug in oplus: ";

}  // namespace

ReadSet Computation::spaced_q(ReadSet q) const {
  return disc ? spaced(q, *disc, by_slide) : std::move(q);
}

bool Computation::is_sum_of_prepared() const {
  return operation.name == "sum" || operation.name == no_fit_name;
}

Region Computation::second_summand(Region q) const {
  return operation.name == no_fit_name ? reflected(std::move(q)) : std::move(q);
}

void Computation::add(std::string& line, const ReadSet& p, const ReadSet& q) const {
  if (!operation.takes_any_p && !is_region(p))
    throw UsageError("P has line strings or points; expected polygons, as P of " + operation.name);
  add(line, result_of(operation, p, q, by_slide));
}

void Computation::add(std::string& line, const slide::PreparedSummand& p,
                      const slide::PreparedSummand& q) const {
  add(line, sum_of_prepared(p, q, operation.boundary).sum);
}

void Computation::add(std::string& line, PlanarSet result) const {
  // Only .dat, which has several lines, can hold an unbounded set.
  if (result.is_unbounded) line += ", \"complement\": true";
  if (form == ResultForm::area) {
    line += ", \"area\": \"" +
            to_string(result.is_unbounded ? area(complement(result)) : area(result), digits) + '"';
    return;
  }
  const bool is_unbounded = result.is_unbounded;
  RoundedSet of_line;
  if (grid)
    of_line = rounded(result, operation.boundary, grid->step, grid->side);
  else
    of_line.set = std::move(result);
  if (is_unbounded) of_line.set = complement(of_line.set);
  if (!grid || is_unbounded) of_line.region = region_of(of_line.set);
  const Format format = form == ResultForm::wkt   ? Format::wkt
                        : form == ResultForm::wkb ? Format::wkb
                                                  : Format::geojson;
  if (format == Format::wkb) require_doubles(of_line.region, of_line.set);
  const std::string text = written(of_line.set, of_line.region, format);
  const char* const quote = form == ResultForm::geojson ? "" : "\"";
  line += ", \"result\": ";
  line += quote;
  line.append(text, 0, text.size() - 1);  // without the end of the line
  line += quote;
}

void add_line(Results& results, const std::string& beginning,
              const std::function<void(std::string& line)>& compute) {
  const std::size_t start = results.lines.size();
  std::string error;
  try {
    results.lines += beginning;
    compute(results.lines);
    results.lines += "}\n";
    ++results.pairs;
    return;
  } catch (const InvalidInput& invalid) {
    error = invalid.what();
  } catch (const UsageError& unsupported) {
    error = unsupported.what();
  } catch (const std::bad_alloc&) {
    error = without_memory;
  } catch (const std::exception& bug) {
    error = std::string(of_a_bug) + bug.what() + "; please report it with the input";
  }
  results.lines.resize(start);
  add_error(results, beginning, error);
}

void add_error(Results& results, const std::string& beginning, const std::string& what) {
  results.lines += beginning + ", \"error\": " + in_json(what) + "}\n";
  ++results.pairs;
  count_error(results, what);
}

void count_error(Results& results, const std::string& what) {
  ++results.errors;
  if (what.starts_with(of_a_bug)) ++results.bugs;
  if (results.first_error.empty()) results.first_error = what;
}

std::string in_json(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace oplus
