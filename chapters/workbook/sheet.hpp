#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "workbook/chance.hpp"
#include "workbook/value.hpp"

namespace workbook {

/// An input that is asked: what it is for, if it was chosen, and the right answer.
struct Probe {
  std::string purpose;
  Value input, right;
};

using Give = std::function<Value(const Value& input)>;

/// An answer that is known beforehand: a wrong one, the stub, or a solution.
struct Known {
  std::string name;
  Give give;
  std::map<std::string, std::string> words;  ///< of the head of its file: "Looks like", "Ask", "Seen in"
};

/// Along which input the figure's two curves are drawn.
struct Curve {
  std::string name;
  double from = 0, to = 1;
  std::function<Value(const Value& input, double at)> put;
  std::size_t number = 0;  ///< which number of the answer is drawn
};

/// An exercise, whatever its types.
struct Sheet {
  std::string asked;                                ///< in one sentence
  std::vector<std::string> names;                   ///< of the arguments
  std::vector<Probe> chosen;                        ///< from the plainest on
  std::function<Value(Chance&)> random;             ///< any other input
  std::function<bool(const Value& input)> allowed;  ///< is it one that the task speaks of?
  Give mend;                                        ///< makes an input whole that was made smaller
  Give judge;                                       ///< the right answer, by a way of its own
  std::function<Sameness(const Value& input)> sameness;
  std::string tolerance;  ///< the same, told to a reader
  Curve curve;
};

/// The chosen probes, and then random ones. Of these only the steady ones: the right answer hardly changes
/// when every
/// number of the input changes a little, so that rounding cannot decide it.
std::vector<Probe> probes_of(const Sheet& sheet, std::size_t random_ones = 200);

/// Is this input allowed, and its answer not decided by rounding?
bool is_fair(const Sheet& sheet, const Value& input);

/// "E = ((0, 0, 2), 0), r = 0.7"
std::string told(const Sheet& sheet, const Value& input);

}  // namespace workbook
