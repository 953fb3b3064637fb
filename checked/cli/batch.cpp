// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "checked/cli/batch/computation.hpp"
#include "checked/cli/batch/geometry_lines.hpp"
#include "checked/cli/batch/interrupted.hpp"
#include "checked/cli/batch/lasting_output.hpp"
#include "checked/cli/batch/line_batches.hpp"
#include "checked/cli/batch/merge_shards.hpp"
#include "checked/cli/batch/ordered_work.hpp"
#include "checked/cli/batch/parts.hpp"
#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/counted.hpp"

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
  bool resume = false;
  std::optional<std::string> shard;
  std::optional<unsigned> threads;
  std::function<std::vector<std::string>()> given;  ///< what makes it this job

  bool has_job() const { return resume || shard; }
};

struct MergeOptions {
  std::vector<std::string> shards;
  std::string output = "-";
};

void require_consistent(const BatchOptions& options) {
  if (options.pairs.has_value() == options.parts.has_value())
    throw UsageError("expected either a file of pairs or --parts FILE");
  if (!options.parts && (options.others || options.unordered))
    throw UsageError("--with and --unordered are for --parts");
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
  if (options.has_job() && !OutputFile::is_replaced(options.output))
    throw UsageError("--resume and --shard need -o FILE, which is a file");
  if (options.parts) require_one_standard_input({*options.parts, options.others.value_or("")});
}

std::vector<PartRotation> rotations_of(const BatchOptions& options) {
  std::vector<PartRotation> all =
      options.rotation_step ? rotations(multiples_of(*options.rotation_step), options.angle_error)
                            : rotations(options.rotations, options.angle_error);
  if (all.empty()) all.emplace_back();
  return all;
}

/// Says at the end what is to be known.
ExitCode say_counts(const Results& all) {
  if (all.repaired > 0)
    say_note(all.first_note +
             (all.repaired == 1
                  ? ""
                  : "; likewise " + counted(all.repaired - 1, "other line", "other lines")));
  if (all.errors == 0) return ExitCode::done;
  say_error(std::to_string(all.errors) + " of " + counted(all.pairs, "line", "lines") +
            (all.errors == 1 ? " is an error: " : " are errors, the first: ") + all.first_error);
  return all.bugs > 0 ? ExitCode::bug : ExitCode::invalid;
}

/// Where results go, how far they are, and which of the job's lines they are.
class Writer {
 public:
  explicit Writer(const BatchOptions& options)
      : shard_(options.shard ? shard_of(*options.shard) : Shard()) {
    std::optional<Job> job;
    if (options.has_job()) {
      std::vector<std::string> inputs;
      for (const auto& input : {options.pairs, options.parts, options.others})
        if (input) inputs.push_back(*input);
      job = job_of(options.given(), inputs, shard_);
    }
    output_.emplace(options.output, std::move(job), options.resume);
    all_ = output_->counts();
    lines_done_ = all_.pairs;
  }

  const Shard& shard() const { return shard_; }

  /// How many lines of the shard were written before.
  std::size_t lines_done() const { return lines_done_; }

  /// Whether a line is to be computed; the job's lines are numbered from 0.
  bool awaits(std::size_t line) const {
    return shard_.has(line) && line / shard_.of >= lines_done_;
  }

  /// Writes the lines, and counts. `all` is all of the input, as results have shares of it; 0 if it is unknown.
  void pass_on(const Results& results, std::size_t all) {
    const std::lock_guard lock(mutex_);
    output_->write(results.lines);
    all_.count(results);
    done_ += results.share;
    if (all > 0) step_.advance(std::min(done_, all), all);
  }

  /// To be called now and then: ends the program where it is interrupted, between two lines and without
  /// a file of half the results, unless these can be gone on with.
  void end_if_interrupted() {
    if (!NotedInterrupt::is_noted()) return;
    const std::unique_lock lock(mutex_, std::chrono::seconds(1));
    if (lock.owns_lock()) output_.reset();
    ShownStep::hide_all();
    NotedInterrupt::end_program();
  }

  ExitCode finish() {
    output_->finish();
    return say_counts(all_);
  }

 private:
  Shard shard_;
  std::optional<LastingOutput> output_;
  ShownStep step_{"computing pairs"};
  std::size_t done_ = 0;
  std::size_t lines_done_ = 0;
  std::timed_mutex mutex_;
  Results all_;
};

Computation computation_of(const BatchOptions& options) {
  return {operation_called(options.operation, options.boundary), options.form,
          output_grid(options.rounding), options.rounding.digits, disc_of(options.spacing)};
}

/// Some lines of a file of pairs, and the number of the first result among all, from 0.
struct Pairs {
  LineBatch lines;
  std::size_t first_result;
};

class PairsOfFile {
 public:
  PairsOfFile(const BatchOptions& options)
      : batches_(*options.pairs),
        overlaps_(options.overlaps),
        computation_(computation_of(options)),
        rotations_(rotations_of(options)) {}

  std::size_t bytes() const { return batches_.bytes(); }

  std::optional<Pairs> next(const std::function<bool()>& is_stopping) {
    std::optional<LineBatch> batch = batches_.next(is_stopping);
    if (!batch) return std::nullopt;
    Pairs pairs{std::move(*batch), results_};
    each_line(pairs.lines, [&](std::string_view text, std::size_t) {
      if (!is_blank_or_comment(text)) results_ += rotations_.size();
    });
    return pairs;
  }

  /// Of those that are awaited.
  template <typename Awaits>
  Results results_of(const Pairs& pairs, const Awaits& awaits) const {
    Results results;
    results.share = pairs.lines.text.size();
    results.lines.reserve(2 * pairs.lines.text.size());
    std::size_t result = pairs.first_result;
    each_line(pairs.lines, [&](std::string_view text, std::size_t number) {
      if (is_blank_or_comment(text)) return;
      std::optional<PairLine> pair;
      std::string id;
      for (const PartRotation& rotation : rotations_) {
        if (!awaits(result++)) continue;
        std::string beginning = "{\"line\": " + std::to_string(number) + rotation.json + id;
        add_line(results, beginning, [&](std::string& line) {
          if (!pair) {
            pair = read_pair_line({batches_.name(), number, text}, overlaps_,
                                  [&](std::string_view given) {
                                    if (!id.empty()) return;
                                    id = ", \"id\": " + std::string(given);
                                    beginning += id;
                                    line += id;
                                  });
            results.note(batches_.name(), number, pair->notes);
          }
          const bool is_last = &rotation == &rotations_.back();
          computation_.add(
              line, pair->p,
              computation_.spaced_q(rotation.turned(is_last ? std::move(pair->q) : pair->q)));
        });
      }
    });
    return results;
  }

 private:
  LineBatches batches_;
  Overlaps overlaps_;
  Computation computation_;
  std::vector<PartRotation> rotations_;
  std::size_t results_ = 0;  ///< of the lines that were taken
};

ExitCode of_pairs(const BatchOptions& options) {
  PairsOfFile pairs(options);
  const NotedInterrupt interrupt;
  Writer writer(options);
  OrderedWork<Pairs, Results>* running = nullptr;
  OrderedWork<Pairs, Results> work({
      .take = [&] { return pairs.next([&] { return running->is_stopping(); }); },
      .work =
          [&](Pairs&& some) {
            return pairs.results_of(some, [&](std::size_t i) { return writer.awaits(i); });
          },
      .pass_on = [&](Results&& results) { writer.pass_on(results, pairs.bytes()); },
  });
  running = &work;
  work.run(number_of(options.threads), [&] { writer.end_if_interrupted(); });
  return writer.finish();
}

/// The results of parts, numbered: first those of invalid parts, then pairs, of which Q changes before P, its
/// rotation before Q.
class PairsOfParts {
 public:
  PairsOfParts(const BatchOptions& options, Results& of_reading)
      : computation_(computation_of(options)), rotations_(rotations_of(options)) {
    p_ = read_parts(*options.parts, options.overlaps, invalid_, of_reading);
    q_ = options.others ? read_parts(*options.others, options.overlaps, invalid_, of_reading) : p_;
    tell_apart(p_, "p");
    tell_apart(q_, "q");
    for (const Part& part : q_)
      for (const PartRotation& rotation : rotations_)
        turned_q_.push_back(computation_.spaced_q(rotation.turned(part.set)));
    std::size_t results = invalid_.size();
    for (std::size_t p = 0; p < p_.size(); ++p) {
      rows_.push_back({results, options.unordered ? p * rotations_.size() : 0});
      results += turned_q_.size() - rows_.back().first_q;
    }
    size_ = results;
    if (!computation_.is_sum_of_prepared()) return;
    for (const Part& part : p_) prepared_p_.emplace_back(part.set.region);
    for (const ReadSet& set : turned_q_)
      prepared_q_.emplace_back(computation_.second_summand(set.region));
  }

  std::size_t size() const { return size_; }

  void add_result(Results& results, std::size_t i) const {
    if (i < invalid_.size())
      return add_error(results, "{\"part\": " + std::to_string(invalid_[i].number),
                       invalid_[i].error);
    const auto row = std::ranges::upper_bound(rows_, i, {}, &Row::first_result) - 1;
    const auto p = static_cast<std::size_t>(row - rows_.begin());
    const std::size_t turned_q = row->first_q + (i - row->first_result);
    const std::size_t q = turned_q / rotations_.size();
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

  /// The results of one P.
  struct Row {
    std::size_t first_result;
    std::size_t first_q;  ///< among those that are turned
  };

  Computation computation_;
  std::vector<PartRotation> rotations_;
  std::vector<InvalidPart> invalid_;
  std::vector<Part> p_, q_;
  std::vector<Row> rows_;
  std::size_t size_ = 0;
  std::vector<ReadSet> turned_q_;  ///< each part by each rotation
  std::vector<slide::PreparedSummand> prepared_p_,
      prepared_q_;  ///< the regions of these, for one sum
};

ExitCode of_parts(const BatchOptions& options) {
  Results of_reading;
  const PairsOfParts pairs(options, of_reading);
  const NotedInterrupt interrupt;
  Writer writer(options);
  writer.pass_on(of_reading, 0);
  constexpr std::size_t results_of_a_lot = 16;
  struct Range {
    std::size_t first, last;
  };
  const std::size_t all = writer.shard().count_of(pairs.size());
  std::size_t next = writer.lines_done();
  const std::size_t to_do = all - std::min(next, all);
  OrderedWork<Range, Results> work({
      .take = [&]() -> std::optional<Range> {
        if (next >= all) return std::nullopt;
        const std::size_t first = next;
        next = std::min(next + results_of_a_lot, all);
        return Range{first, next};
      },
      .work =
          [&](Range&& range) {
            Results results;
            results.share = range.last - range.first;
            for (std::size_t i = range.first; i < range.last; ++i)
              pairs.add_result(results, writer.shard().task(i));
            return results;
          },
      .pass_on = [&](Results&& results) { writer.pass_on(results, to_do); },
  });
  work.run(number_of(options.threads), [&] { writer.end_if_interrupted(); });
  return writer.finish();
}

ExitCode batch(const BatchOptions& options) {
  require_consistent(options);
  require_writable({options.output});
  return options.pairs ? of_pairs(options) : of_parts(options);
}

ExitCode merge(const MergeOptions& options) {
  require_writable({options.output});
  return say_counts(merge_shards(options.shards, options.output));
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
          "turn Q by each of these angles in degrees, about the origin, for a line each; such as 0,90,180")
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
  command.flag(
      "--resume", options.resume,
      "write them into -o FILE as they come, and go on where it ends if it exists, for example after a "
      "kill. FILE.oplus-job beside it says which job it is (docs/many_machines.md)");
  command.option("--shard I/N", options.shard,
                 "only the I-th of N parts of the results, for 'oplus batch merge'");
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
      "  2  some lines are errors; or invalid usage, or a file that cannot be read or written; or --resume of\n"
      "     the output of another job\n"
      "  3  a bug in oplus; please report it");
  options.given = [of_batch = command] {
    return of_batch.given({"--help", "--output", "--resume", "--shard", "--threads"});
  };
  const auto merged = std::make_shared<MergeOptions>();
  const Command below = program.add_below(
      command, "merge", "Merge all shards into the output that one run would have written",
      [merged] { return static_cast<int>(merge(*merged)); });
  below.option("SHARDS FILE", merged->shards, "the outputs of all shards, in any order").required();
  below.file("-o,--output", merged->output,
             "write the results there, as a whole at the end; by default to standard output");
  below.footer(
      "FILE.oplus-job must be beside each FILE, as oplus batch --shard writes it (docs/many_machines.md).\n"
      "\n"
      "Example:\n"
      "  oplus gen star --n 12 --seed 3 >parts.txt\n"
      "  oplus batch --parts parts.txt --rotations 0,90 --shard 1/2 -o shard.1.jsonl\n"
      "  oplus batch --parts parts.txt --rotations 0,90 --shard 2/2 -o shard.2.jsonl\n"
      "  oplus batch merge shard.*.jsonl -o all.jsonl\n"
      "\n"
      "Exit codes:\n"
      "  0  done: all pairs were computed\n"
      "  2  some lines are errors; or shards are missing, double, cut, or of different jobs\n"
      "  3  some lines say that there is a bug in oplus; please report it");
}

}  // namespace oplus
