// SPDX-License-Identifier: MIT
#include "checked/verify/verdict_text.hpp"

#include <algorithm>
#include <set>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string membership(const Reason& reason) {
  if (reason.in_sum == reason.in_given)
    return reason.in_sum ? "is in the sum and in S" : "is neither in the sum nor in S";
  return reason.in_sum ? "is in the sum, but not in S" : "is in S, but not in the sum";
}

}  // namespace

std::string text_of(const Verdict& verdict) {
  if (verdict.is_sum()) return "yes\n";
  const Reason& first = verdict.reasons.front();
  const std::string x = to_string(first.witness);
  std::string text = "no: " + describe(first.kind) + ": " + first.detail + "\nwitness: " + x + " " +
                     membership(first);
  if (verdict.addends)
    text +=
        ": " + to_string(verdict.addends->p) + " of P + " + to_string(verdict.addends->q) + " of Q";
  else if (!first.in_sum)
    text += ": the interiors of P and -Q + " + x + " do not meet";
  text += "\n";
  std::set<ReasonKind> said = {first.kind};
  for (const Reason& reason : verdict.reasons) {
    if (!said.insert(reason.kind).second) continue;
    text += "also: " + describe(reason.kind) + ": " + reason.detail + "; at " +
            to_string(reason.witness) + "\n";
  }
  for (const ReasonKind kind : said) {
    const auto count = std::count_if(verdict.reasons.begin(), verdict.reasons.end(),
                                     [&](const Reason& reason) { return reason.kind == kind; });
    if (count > 1) text += "in all: " + describe(kind) + ", " + std::to_string(count) + " times\n";
  }
  return text;
}

}  // namespace oplus
