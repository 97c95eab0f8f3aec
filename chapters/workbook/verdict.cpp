#include "workbook/verdict.hpp"

#include <algorithm>

#include "workbook/shrink.hpp"

namespace workbook {
namespace {

constexpr double a_little = 1e-3;

bool is_right(const Sheet& sheet, const Probe& probe, const Value& answer) {
  return same(answer, probe.right, sheet.sameness(probe.input));
}
bool is_nearly_right(const Sheet& sheet, const Probe& probe, const Value& answer) {
  Sameness loose = sheet.sameness(probe.input);
  loose.tolerance = a_little;
  return same(answer, probe.right, loose);
}

// The same answer to inputs whose right answers differ.
bool is_constant(const std::vector<Probe>& probes, const std::vector<Value>& answers) {
  if (has_nan(answers.front())) return false;
  const auto differs = [&](const Value& answer) { return !same(answer, answers.front(), {}); };
  if (std::any_of(answers.begin(), answers.end(), differs)) return false;
  return std::any_of(probes.begin(), probes.end(),
                     [&](const Probe& probe) { return !same(probe.right, probes.front().right, {}); });
}

// A chosen input stays as it is, for it was chosen; a random one becomes as small as it can.
Probe plainest(const Sheet& sheet, const Probe& probe, const Ask& ask) {
  if (!probe.purpose.empty()) return probe;
  const auto fails = [&](const Value& smaller) {
    const Value input = sheet.mend(smaller);
    if (!is_fair(sheet, input)) return false;
    const Reply reply = ask(input);
    return reply.kind == Reply::Kind::answer &&
           !is_right(sheet, {"", input, sheet.judge(input)}, reply.value);
  };
  const Value input = sheet.mend(shrunk(probe.input, fails));
  return {"", input, sheet.judge(input)};
}

}  // namespace

bool same_on_all(const Sheet& sheet, const std::vector<Probe>& probes, const std::vector<Value>& answers,
                 const Give& give) {
  for (std::size_t i = 0; i < probes.size(); ++i)
    if (!same(answers[i], give(probes[i].input), sheet.sameness(probes[i].input))) return false;
  return true;
}

Verdict examine(const Sheet& sheet, const std::vector<Known>& known, const Ask& ask) {
  const std::vector<Probe> probes = probes_of(sheet);
  Verdict verdict;
  verdict.probes = probes.size();
  std::vector<Value> answers;
  const Probe* first = nullptr;
  for (const Probe& probe : probes) {
    const Reply reply = ask(probe.input);
    if (reply.kind != Reply::Kind::answer)
      return {Verdict::Kind::broken, probes.size(), 1, false, probe, reply, nullptr};
    answers.push_back(reply.value);
    if (is_right(sheet, probe, reply.value)) continue;
    verdict.nearly = (verdict.failed++ == 0 || verdict.nearly) && is_nearly_right(sheet, probe, reply.value);
    if (!first) first = &probe;
  }
  if (!first) return verdict;
  const auto match = std::find_if(known.begin(), known.end(), [&](const Known& each) {
    return same_on_all(sheet, probes, answers, each.give);
  });
  verdict.known = match == known.end() ? nullptr : &*match;
  verdict.kind = verdict.known                  ? Verdict::Kind::known
                 : is_constant(probes, answers) ? Verdict::Kind::constant
                                                : Verdict::Kind::wrong;
  verdict.probe = plainest(sheet, *first, ask);
  verdict.reply = ask(verdict.probe.input);
  return verdict;
}

}  // namespace workbook
