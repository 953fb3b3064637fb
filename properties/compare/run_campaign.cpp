// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/run_campaign.hpp"

#include <optional>
#include <system_error>
#include <utility>

#include "checked/cli/batch/ordered_work.hpp"

namespace oplus {

namespace {

constexpr std::size_t pairs_until_kept = 256;

/// Which source a task is of, and its number there.
struct TaskNumber {
  std::size_t source;
  std::size_t task;
};

TaskNumber number_of(std::size_t index, const std::vector<TaskSource>& sources) {
  TaskNumber number{0, index};
  while (number.task >= sources.at(number.source).tasks)
    number.task -= sources[number.source++].tasks;
  return number;
}

/// judged(), or nullopt where an engine was interrupted.
std::optional<JudgedPair> judged_unless_interrupted(const Task& task, const Rules& rules) {
  try {
    return judged(task, rules);
  } catch (const std::system_error& e) {
    if (e.code() == std::errc::interrupted) return std::nullopt;
    throw;
  }
}

/// Shrinks the pair as long as the failure stays of its kind. Returns whether it was not interrupted.
bool shrink(ShrunkFailure& found, const Statement* statement, const Campaign& campaign,
            const Rules& rules, const RunWatch& watch) {
  const bool breaks_statement = found.sum.failure.kind.starts_with("breaks ");
  Rules again = rules;
  again.boundaries = {found.sum.boundary};
  again.asks_beyond = true;
  std::erase_if(again.engines, [&](const auto& engine) { return engine.name != found.sum.engine; });
  // Without a sum there is nothing to judge.
  if (!found.sum.given && !again.engines.empty() && !breaks_statement) again.largest = 0;
  // Each pair that hangs takes the whole time limit.
  const bool hangs = found.sum.failure.kind == "hung";
  const std::size_t most = hangs ? campaign.shrink_tries / 20 : campaign.shrink_tries;
  bool is_interrupted = false;
  const auto fails = [&](const Summands& pair) {
    is_interrupted = is_interrupted || watch.is_interrupted();
    if (is_interrupted || found.tries > most) return false;
    watch.while_shrinking(found);
    ++found.tries;
    const auto judgement = judged_unless_interrupted(
        {"", pair, nullptr, breaks_statement ? statement : nullptr}, again);
    is_interrupted = !judgement;
    if (is_interrupted) return false;
    for (const JudgedSum& sum : judgement->sums) {
      // A statement may blame one of its own pairs; only the asked one can be shrunk further.
      if (!sum.wrong || sum.wrong->failure.kind != found.sum.failure.kind ||
          sum.wrong->engine != found.sum.engine || sum.wrong->pair != pair)
        continue;
      found.sum = *sum.wrong;
      return true;
    }
    return false;
  };
  const Summands first = found.sum.pair;
  found.is_repeatable = fails(first) || is_interrupted;
  if (!found.is_repeatable || is_interrupted) return !is_interrupted;
  bool is_first = true;
  oplus::shrink(
      first, [&](const Summands& pair) { return std::exchange(is_first, false) || fails(pair); });
  found.is_shrunk = found.tries <= most && !is_interrupted;
  return !is_interrupted;
}

}  // namespace

CampaignReport run_campaign(CampaignReport report, const std::vector<TaskSource>& sources,
                            const Rules& rules, unsigned threads, const RunWatch& watch) {
  struct Judged {
    std::size_t index;
    TaskNumber number;
    Task task;
    std::optional<JudgedPair> judgement;
  };
  report.has_stopped_shrinking = false;
  const auto keep = [&] {
    keep_smallest(report);
    if (watch.keep) watch.keep(report);
  };
  std::size_t next = report.done;
  bool all_were_judged = true;
  OrderedWork<std::size_t, Judged> work({
      .take = [&]() -> std::optional<std::size_t> {
        if (next == report.pairs || watch.is_interrupted()) return std::nullopt;
        return next++;
      },
      .work =
          [&](std::size_t k) {
            const std::size_t index = report.shard.task(k);
            const TaskNumber number = number_of(index, sources);
            Task task = sources[number.source].task(number.task);
            std::optional<JudgedPair> judgement = judged_unless_interrupted(task, rules);
            return Judged{index, number, std::move(task), std::move(judgement)};
          },
      .pass_on =
          [&](Judged&& pair) {
            all_were_judged = all_were_judged && pair.judgement;
            if (!all_were_judged) return;
            add(report, pair.number.source, pair.index, pair.task, *pair.judgement);
            ++report.done;
            watch.after_pair();
            if (watch.keep && report.done % pairs_until_kept == 0) keep();
          },
  });
  work.run(threads, [] {});
  keep();
  for (auto& [kind, found] : report.counterexamples) {
    const TaskNumber number = number_of(found.index, sources);
    const Statement* const statement = sources[number.source].task(number.task).statement;
    if (!shrink(found, statement, report.campaign, rules, watch))
      report.has_stopped_shrinking = true;
    watch.while_shrinking(found);
  }
  return report;
}

}  // namespace oplus
