// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <mutex>

#include "checked/cli/batch/computation.hpp"
#include "checked/cli/batch/geometry_lines.hpp"
#include "checked/cli/batch/interrupted.hpp"
#include "checked/cli/batch/line_batches.hpp"
#include "checked/cli/batch/ordered_work.hpp"
#include "checked/cli/batch/parts.hpp"
#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/spacing.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

struct BatchOptions {
  std::optional<std::string> pairs;
  std::optional<std::string> parts;
  std::optional<std::string> others;
  bool unordered = false;
  std::vector<std::string> rotations;
  std::optional<std::string> rotation_step;
  std::string angle_error = default_angle_error;
  std::string operation = "sum";
  SpacingOptions spacing;
  Boundary boundary = Boundary::closed;
  Overlaps overlaps = Overlaps::refused;
  ResultForm form = ResultForm::wkt;
  RoundingOptions rounding;
  std::string output = "-";
  std::optional<unsigned> threads;
};

void require_consistent(const BatchOptions& options) {
  if (options.pairs.has_value() == options.parts.has_value())
    throw UsageError("expected either a file of pairs or --parts FILE");
  const bool is_rotated = !options.rotations.empty() || options.rotation_step;
  if (!options.parts && (options.others || options.unordered || is_rotated))
    throw UsageError("--with, --unordered and rotations are for --parts");
  if (options.unordered && options.others)
    throw UsageError("--unordered is for the pairs of one file, without --with");
  if (!options.rotations.empty() && options.rotation_step)
    throw UsageError("expected either --rotations or --rotation-step");
  if (options.boundary == Boundary::open && options.operation != "sum")
    throw UsageError("--open is for --operation sum");
  if (options.spacing.distance && !operation_called(options.operation).takes_spacing)
    throw UsageError("--spacing is for --operation nfp and ifp");
  angle_error(options.angle_error);
  output_grid(options.rounding);
  if (options.form == ResultForm::area && (options.rounding.grid || options.rounding.side))
    throw UsageError("--grid and --side are for geometries; areas are rounded by --digits");
  if (options.parts) require_one_standard_input({*options.parts, options.others.value_or("")});
}

/// Where results go, and how far they are.
class Writer {
 public:
  explicit Writer(const std::string& path) : output_(path) {}

  /// Writes the lines, and counts. `all` is all of the input, as results have shares of it; 0 if it is unknown.
  void pass_on(const Results& results, std::size_t all) {
    const std::lock_guard lock(mutex_);
    output_->write(results.lines);
    all_.count(results);
    done_ += results.share;
    if (all > 0) step_.advance(std::min(done_, all), all);
  }

  /// To be called now and then: ends the program where it is interrupted, between two lines and without
  /// a file of half the results.
  void end_if_interrupted() {
    if (!NotedInterrupt::is_noted()) return;
    const std::unique_lock lock(mutex_, std::chrono::seconds(1));
    if (lock.owns_lock()) output_.reset();
    ShownStep::hide_all();
    NotedInterrupt::end_program();
  }

  /// Says at the end what is to be known.
  ExitCode finish() {
    output_->finish();
    if (all_.repaired > 0)
      say_note(all_.first_note +
               (all_.repaired == 1
                    ? ""
                    : "; likewise " + counted(all_.repaired - 1, "other line", "other lines")));
    if (all_.errors == 0) return ExitCode::done;
    say_error(std::to_string(all_.errors) + " of " + counted(all_.pairs, "line", "lines") +
              (all_.errors == 1 ? " is an error: " : " are errors, the first: ") +
              all_.first_error);
    return all_.bugs > 0 ? ExitCode::bug : ExitCode::invalid;
  }

 private:
  std::optional<CommandOutput> output_;
  ShownStep step_{"computing pairs"};
  std::size_t done_ = 0;
  std::timed_mutex mutex_;
  Results all_;
};

Computation computation_of(const BatchOptions& options) {
  return {operation_called(options.operation, options.boundary), options.form,
          output_grid(options.rounding), options.rounding.digits, disc_of(options.spacing)};
}

Results results_of(const LineBatch& batch, const std::string& file, Overlaps overlaps,
                   const Computation& computation) {
  Results results;
  results.share = batch.text.size();
  results.lines.reserve(2 * batch.text.size());
  each_line(batch, [&](std::string_view text, std::size_t number) {
    if (is_blank_or_comment(text)) return;
    std::string beginning = "{\"line\": " + std::to_string(number);
    add_line(results, beginning, [&](std::string& line) {
      PairLine pair = read_pair_line({file, number, text}, overlaps);
      results.note(file, number, pair.notes);
      if (!pair.id.empty()) {
        const std::string id = ", \"id\": " + pair.id;
        beginning += id;
        line += id;
      }
      computation.add(line, pair.p, computation.spaced_q(std::move(pair.q)));
    });
  });
  return results;
}

ExitCode of_pairs(const BatchOptions& options) {
  LineBatches batches(*options.pairs);
  const Computation computation = computation_of(options);
  const NotedInterrupt interrupt;
  Writer writer(options.output);
  OrderedWork<LineBatch, Results>* running = nullptr;
  OrderedWork<LineBatch, Results> work({
      .take = [&] { return batches.next([&] { return running->is_stopping(); }); },
      .work =
          [&](LineBatch&& batch) {
            return results_of(batch, batches.name(), options.overlaps, computation);
          },
      .pass_on = [&](Results&& results) { writer.pass_on(results, batches.bytes()); },
  });
  running = &work;
  work.run(number_of(options.threads), [&] { writer.end_if_interrupted(); });
  return writer.finish();
}

/// The pairs of parts, numbered: Q changes before P, its rotation before Q.
class PairsOfParts {
 public:
  PairsOfParts(const BatchOptions& options, Results& results)
      : is_unordered_(options.unordered), computation_(computation_of(options)) {
    rotations_ = options.rotation_step
                     ? rotations(multiples_of(*options.rotation_step), options.angle_error)
                     : rotations(options.rotations, options.angle_error);
    if (rotations_.empty()) rotations_.emplace_back();
    p_ = read_parts(*options.parts, options.overlaps, results);
    q_ = options.others ? read_parts(*options.others, options.overlaps, results) : p_;
    tell_apart(p_, "p");
    tell_apart(q_, "q");
    for (const Part& part : q_)
      for (const PartRotation& rotation : rotations_)
        turned_q_.push_back(computation_.spaced_q(rotation.turned(part.set)));
    if (!computation_.is_sum_of_prepared()) return;
    for (const Part& part : p_) prepared_p_.emplace_back(part.set.region);
    for (const ReadSet& set : turned_q_)
      prepared_q_.emplace_back(computation_.second_summand(set.region));
  }

  /// Those to be left out are counted, too.
  std::size_t size() const { return p_.size() * turned_q_.size(); }

  Results results_of(std::size_t first, std::size_t last) const {
    Results results;
    results.share = last - first;
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t p = i / turned_q_.size(), turned_q = i % turned_q_.size();
      const std::size_t q = turned_q / rotations_.size();
      if (is_unordered_ && q < p) continue;
      add_line(results,
               "{" + p_[p].name + ", " + q_[q].name + rotations_[turned_q % rotations_.size()].json,
               [&](std::string& line) {
                 if (computation_.is_sum_of_prepared() && is_region(p_[p].set) &&
                     is_region(turned_q_[turned_q]))
                   computation_.add(line, prepared_p_[p], prepared_q_[turned_q]);
                 else
                   computation_.add(line, p_[p].set, turned_q_[turned_q]);
               });
    }
    return results;
  }

 private:
  /// Makes members of names, `"p": "bracket"`; where two parts have one name, with their numbers.
  static void tell_apart(std::vector<Part>& parts, const std::string& member) {
    std::map<std::string, std::size_t> times;
    for (const Part& part : parts) ++times[part.name];
    for (Part& part : parts) {
      const bool is_one_of_several = times[part.name] > 1;
      part.name = '"' + member + "\": " + part.name;
      if (is_one_of_several)
        part.name += ", \"" + member + "_part\": " + std::to_string(part.number);
    }
  }

  bool is_unordered_;
  Computation computation_;
  std::vector<PartRotation> rotations_;
  std::vector<Part> p_, q_;
  std::vector<ReadSet> turned_q_;  ///< each part by each rotation
  std::vector<slide::PreparedSummand> prepared_p_,
      prepared_q_;  ///< the regions of these, for one sum
};

ExitCode of_parts(const BatchOptions& options) {
  Results of_reading;
  const PairsOfParts pairs(options, of_reading);
  const NotedInterrupt interrupt;
  Writer writer(options.output);
  writer.pass_on(of_reading, 0);
  constexpr std::size_t pairs_of_a_batch = 16;
  struct Range {
    std::size_t first, last;
  };
  std::size_t next = 0;
  OrderedWork<Range, Results> work({
      .take = [&]() -> std::optional<Range> {
        if (next == pairs.size()) return std::nullopt;
        const std::size_t first = next;
        next = std::min(next + pairs_of_a_batch, pairs.size());
        return Range{first, next};
      },
      .work = [&](Range&& range) { return pairs.results_of(range.first, range.last); },
      .pass_on = [&](Results&& results) { writer.pass_on(results, pairs.size()); },
  });
  work.run(number_of(options.threads), [&] { writer.end_if_interrupted(); });
  return writer.finish();
}

ExitCode batch(const BatchOptions& options) {
  require_consistent(options);
  require_writable({options.output});
  return options.pairs ? of_pairs(options) : of_parts(options);
}

}  // namespace

void add_batch(Program& program) {
  const auto& [command, options] = program.add(
      "batch", "Compute a sum, or another operation, of many pairs of regions or other sets",
      batch);
  command.file(
      "PAIRS", options.pairs,
      "two geometries a line, with a tab between them, each WKT or GeoJSON, or a JSON object "
      "{\"p\": ..., \"q\": ...}; - is standard input");
  command.file(
      "--parts", options.parts,
      "one geometry a line, or its name, a tab and the geometry: computes all pairs of them, also "
      "each with itself");
  command.file("--with", options.others, "those of this file are Q, those of --parts are P");
  command.flag("--unordered", options.unordered, "of --parts: no pair the other way round");
  command
      .option(
          "--rotations ANGLE,...", options.rotations,
          "of --parts: turn Q by each of these angles in degrees, about the origin; such as 0,90,180")
      .separated_by_commas();
  command.option("--rotation-step ANGLE", options.rotation_step,
                 "the same by all multiples of this angle, at least 0.1, that are less than 360");
  add_angle_error(command, options.angle_error);
  command
      .option(
          "--operation NAME", options.operation,
          "what to compute, by default sum: " + joined(operation_names(), std::identity(), ", "))
      .one_of(operation_names());
  add_spacing(command, options.spacing);
  add_open(command, options.boundary, "sum the regions' interiors, as in oplus sum");
  add_union(command, options.overlaps, "each geometry");
  command.choice<ResultForm>(
      "--format", options.form,
      {{"wkt", ResultForm::wkt},
       {"geojson", ResultForm::geojson},
       {"wkb", ResultForm::wkb},
       {"area", ResultForm::area}},
      "write results as wkt, in a string, by default; as geojson; as wkb, in hexadecimal digits; or only "
      "their area");
  add_rounding(command, options.rounding);
  command.file(
      "-o,--output", options.output,
      "write the results there, as a whole at the end; by default to standard output, as they "
      "come");
  add_threads(command, options.threads, "");
  command.footer(
      "Writes a line of JSON for each pair, in the order of the input (docs/batch.md). A pair that is "
      "invalid gets\n"
      "a line with an \"error\", and the others are computed. Blank lines and lines that start with # "
      "are left out.\n"
      "\n"
      "Example:\n"
      "  oplus gen star --n 12 --seed 3 >parts.txt\n"
      "  oplus gen star --n 9 --seed 4 >>parts.txt\n"
      "  oplus batch --parts parts.txt --rotation-step 90 --operation nfp -o no_fit.jsonl\n"
      "\n"
      "Exit codes:\n"
      "  0  done: all pairs were computed\n"
      "  2  some lines are errors; or invalid usage, or a file that cannot be read or written\n"
      "  3  a bug in oplus; please report it");
}

}  // namespace oplus
