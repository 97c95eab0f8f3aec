#pragma once
#include <functional>
#include <string>
#include <vector>

#include "workbook/sheet.hpp"

namespace workbook {

/// What came back when an answer was asked.
struct Reply {
  enum class Kind { answer, crashed, endless, threw, ended, out_of_memory };
  Kind kind = Kind::answer;
  Value value;  ///< of an answer
  std::string
      words;  ///< what was thrown, the last that was said, or what was printed on the way to the answer
};
using Ask = std::function<Reply(const Value& input)>;

/// What is to be said of an answer.
struct Verdict {
  enum class Kind {
    right,
    broken,    ///< one probe brought no answer at all
    constant,  ///< the same to everything: as shipped
    known,     ///< the same as a known wrong one on all probes
    wrong      ///< anything else
  };
  Kind kind = Kind::right;
  std::size_t probes = 0, failed = 0;
  bool nearly = false;  ///< what fails is off by less than a thousandth
  Probe probe;          ///< the plainest chosen one that fails, or the smallest of the random ones
  Reply reply;          ///< to it
  const Known* known = nullptr;
};

/// Asks all probes. \param known  wrong answers, compared by what they answer to all probes
Verdict examine(const Sheet& sheet, const std::vector<Known>& known, const Ask& ask);

/// Is there an input on which two answers differ, among these?
bool same_on_all(const Sheet& sheet, const std::vector<Probe>& probes, const std::vector<Value>& answers,
                 const Give& give);

}  // namespace workbook
