// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/run_campaign.hpp"

#include <algorithm>
#include <mutex>

#include "checked/slide/for_each_number.hpp"

namespace oplus {

namespace {

constexpr std::size_t pairs_at_a_time = 256;

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

/// Shrinks the pair as long as the failure stays of its kind.
void shrink(ShrunkFailure& found, const Statement* statement, const Campaign& campaign,
            const Rules& rules) {
  const bool breaks_statement = found.sum.failure.kind.starts_with("breaks ");
  Rules again = rules;
  again.boundaries = {found.sum.boundary};
  again.asks_beyond = true;
  std::erase_if(again.engines, [&](const auto& engine) { return engine.name != found.sum.engine; });
  // An answer without a sum needs no oracle.
  if (!found.sum.given && !again.engines.empty() && !breaks_statement) again.largest = 0;
  // A pair that hangs costs all the time it is given.
  const bool hangs = found.sum.failure.kind == "hung";
  const std::size_t most = hangs ? campaign.shrink_tries / 20 : campaign.shrink_tries;
  std::optional<WrongSum> last;
  const auto fails = [&](const Summands& pair) {
    if (found.tries > most) return false;
    ++found.tries;
    const JudgedPair judgement =
        judged({"", pair, nullptr, breaks_statement ? statement : nullptr}, again);
    for (const JudgedSum& sum : judgement.sums) {
      // A statement may blame one of its own pairs; only the asked one can be shrunk further.
      if (!sum.wrong || sum.wrong->failure.kind != found.sum.failure.kind ||
          sum.wrong->engine != found.sum.engine || sum.wrong->pair != pair)
        continue;
      last = sum.wrong;
      return true;
    }
    return false;
  };
  found.is_repeatable = fails(found.sum.pair);
  if (!found.is_repeatable) return;
  bool is_first = true;
  oplus::shrink(found.sum.pair, [&](const Summands& pair) {
    return std::exchange(is_first, false) || fails(pair);
  });
  found.sum = std::move(*last);
  found.is_shrunk = found.tries <= most;
}

}  // namespace

CampaignReport run_campaign(CampaignReport report, const std::vector<TaskSource>& sources,
                            const Rules& rules, unsigned threads, const RunWatch& watch) {
  std::mutex adding;
  bool is_enough = false;
  while (report.done < report.pairs && !is_enough) {
    const std::size_t left = report.pairs - report.done;
    const std::size_t some = watch.is_enough ? std::min(left, pairs_at_a_time) : left;
    slide::for_each_number(some, threads, [&](std::size_t k) {
      const std::size_t index = report.shard.task(report.done + k);
      const TaskNumber number = number_of(index, sources);
      const Task task = sources[number.source].task(number.task);
      const JudgedPair judgement = judged(task, rules);
      const std::lock_guard lock(adding);
      add(report, number.source, index, task, judgement);
      watch.after_pair();
    });
    report.done += some;
    keep_smallest(report);
    is_enough = watch.is_enough && watch.is_enough(report);
  }
  for (auto& [kind, found] : report.counterexamples) {
    watch.before_shrinking(found);
    const TaskNumber number = number_of(found.index, sources);
    shrink(found, sources[number.source].task(number.task).statement, report.campaign, rules);
  }
  return report;
}

}  // namespace oplus
