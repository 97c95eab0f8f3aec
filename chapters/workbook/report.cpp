#include "workbook/report.hpp"

#include <fstream>

namespace workbook {
namespace {

constexpr double beyond_doubt = 0.1;
constexpr std::size_t width = 110, indent = 14, most_printed = 400;

// A line of the report: its name on the left, its words wrapped beside it.
void row(std::ostream& out, std::string name, const std::string& words) {
  name.resize(indent - 2, ' ');
  std::string line = "  " + name, rest = words;
  while (!rest.empty()) {
    const std::size_t room = width - indent;
    std::size_t end = rest.size() <= room ? rest.size() : rest.rfind(' ', room);
    if (end == std::string::npos || end == 0) end = std::min(rest.find(' '), rest.size());
    out << line << rest.substr(0, end) << '\n';
    rest.erase(0, std::min(rest.size(), end + 1));
    line.assign(indent, ' ');
  }
}

std::string what_came(const Reply& reply, double step) {
  switch (reply.kind) {
    case Reply::Kind::answer:
      return shown(rounded(reply.value, step));
    case Reply::Kind::crashed:
      return "a crash (" + reply.words + ")";
    case Reply::Kind::endless:
      return "no answer in time: an endless loop, or a very long one";
    case Reply::Kind::threw:
      return "an exception: " + reply.words;
    case Reply::Kind::ended:
      return "the program ended itself (" + reply.words + ")";
    case Reply::Kind::out_of_memory:
      return "more memory than there is: does something grow without end?";
  }
  return "";
}

std::string question_for(const Reply& reply) {
  switch (reply.kind) {
    case Reply::Kind::crashed:
      return "is there an index beyond the end, a look into an optional that is empty, a function that calls "
             "itself for "
             "ever?";
    case Reply::Kind::endless:
      return "which loop has an end that is never reached with this input?";
    case Reply::Kind::threw:
      return "who throws it, and what did it ask for?";
    case Reply::Kind::ended:
      return "who calls exit? An answer is returned.";
    case Reply::Kind::answer:
    case Reply::Kind::out_of_memory:
      break;
  }
  return "";
}

void tell_known(std::ostream& out, const Known& known) {
  for (const auto& [key, title] :
       {std::pair{"Looks like", "looks like"}, {"Ask", "ask"}, {"Seen in", "seen in"}})
    if (const auto found = known.words.find(key); found != known.words.end()) row(out, title, found->second);
}

void tell_question(std::ostream& out, const Verdict& verdict) {
  const auto& [kind, probes, failed, nearly, probe, reply, known] = verdict;
  if (kind == Verdict::Kind::constant)
    row(out, "as shipped",
        "the same answer to everything, " + shown(reply.value) +
            ": nothing is written yet, or nothing of the input is used.");
  else if (known)
    tell_known(out, *known);
  else if (const std::string question = question_for(reply); !question.empty())
    row(out, "ask", question);
  else if (has_nan(reply.value))
    row(out, "ask",
        "not a number (NaN) came out: where is 0 divided by 0, 0 multiplied by infinity, or the root of a "
        "negative number taken?");
  else if (nearly)
    row(out, "ask",
        "all is nearly right, and no more: is something a float, a rounded constant, a tolerance, a search "
        "that ends "
        "too early?");
  else if (probe.purpose.empty())
    row(out, "ask",
        "this is the smallest of the random inputs that go wrong. Draw it: what is special about it?");
}

}  // namespace

std::map<std::string, std::string> head_of(const std::string& file) {
  std::ifstream in(file);
  std::map<std::string, std::string> words;
  std::string key;
  for (std::string line; std::getline(in, line) && line.starts_with("//");) {
    line.erase(0, std::min<std::size_t>(3, line.size()));
    const auto colon = line.find(": ");
    const bool begins = colon != std::string::npos && colon < 12 && line[0] >= 'A' && line[0] <= 'Z';
    if (begins)
      words[key = line.substr(0, colon)] = line.substr(colon + 2);
    else if (!key.empty())
      words[key] += " " + line;
  }
  return words;
}

void tell(std::ostream& out, const Sheet& sheet, const Verdict& verdict) {
  const auto& [kind, probes, failed, nearly, probe, reply, known] = verdict;
  if (kind == Verdict::Kind::right) {
    row(out, "right", "all " + std::to_string(probes) + " probes, to within " + sheet.tolerance + ".");
    return;
  }
  row(out, "asked", sheet.asked);
  row(out, "input", told(sheet, probe.input));
  if (!probe.purpose.empty()) row(out, "which is", probe.purpose);
  const Sameness sameness = sheet.sameness(probe.input);
  const double step =
      beyond_doubt * sameness.tolerance * sameness.unit;  // smaller differences are nobody's fault
  row(out, "expected", shown(rounded(probe.right, step)));
  row(out, "got", what_came(reply, step));
  if (reply.kind == Reply::Kind::answer && !reply.words.empty())
    row(out, "you printed", reply.words.substr(0, most_printed));
  tell_question(out, verdict);
  if (kind != Verdict::Kind::broken)
    row(out, "probes",
        std::to_string(failed) + " of " + std::to_string(probes) + " go wrong (more than " + sheet.tolerance +
            " off).");
}

std::string word_for(const Verdict& verdict) {
  switch (verdict.kind) {
    case Verdict::Kind::right:
      return "right";
    case Verdict::Kind::constant:
      return "constant";
    case Verdict::Kind::known:
      return "known:" + verdict.known->name;
    case Verdict::Kind::wrong:
      return has_nan(verdict.reply.value) ? "nan" : "wrong";
    case Verdict::Kind::broken:
      break;
  }
  switch (verdict.reply.kind) {
    case Reply::Kind::crashed:
      return "crash";
    case Reply::Kind::endless:
      return "endless";
    case Reply::Kind::threw:
      return "exception";
    case Reply::Kind::ended:
      return "ended";
    default:
      return "memory";
  }
}

}  // namespace workbook
