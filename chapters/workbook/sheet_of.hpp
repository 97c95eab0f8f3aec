#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "workbook/convert.hpp"
#include "workbook/sheet.hpp"

namespace workbook {

/// What a number of the answer is measured by.
enum class Unit {
  one,    ///< 1: shares of a motion, truths, counts
  scene,  ///< the largest number of the input: places and lengths
};

/// What probes.hpp of an exercise says: all that is needed to judge an answer.
template <class Signature>
struct Exercise {
  using Input = typename Arguments<Signature>::Tuple;
  using Answer = typename Arguments<Signature>::Result;
  struct Chosen {
    std::string purpose;  ///< what this input is for
    Input input;
  };
  struct Along {
    std::string name;  ///< of what is changed in the first chosen input, or in the one that went wrong
    double from = 0, to = 1;
    std::function<void(Input&, double)> put;
    std::size_t number = 0;  ///< which number of the answer is drawn
  };

  std::string asked;
  std::vector<std::string> names;
  std::vector<Chosen> chosen;
  std::function<Input(Chance&)> random;
  std::function<bool(const Input&)> allowed = [](const Input&) { return true; };
  /// What depends on other parts of an input, and must follow when these become smaller.
  std::function<Input(const Input&)> mend = [](const Input& input) { return input; };
  Signature* judge = nullptr;
  double tolerance = 1e-9;  ///< relative to the larger of two numbers, or to the unit
  Unit unit = Unit::one;
  bool any_order = false;  ///< of a list
  Along along;
};

template <class Signature>
class SheetOf {
 public:
  static Sheet make(const Exercise<Signature>& exercise) {
    const auto give = [judge = exercise.judge](const Value& input) { return answer_of(judge, input); };
    Sheet sheet{exercise.asked, exercise.names, {}, {}, {}, {}, give, {}, told_tolerance(exercise), {}};
    for (const auto& [purpose, input] : exercise.chosen)
      sheet.chosen.push_back({purpose, to_value(input), {}});
    sheet.random = [random = exercise.random](Chance& chance) { return to_value(random(chance)); };
    sheet.allowed = [allowed = exercise.allowed](const Value& input) { return allowed(tuple(input)); };
    sheet.mend = [mend = exercise.mend](const Value& input) { return to_value(mend(tuple(input))); };
    sheet.sameness = [exercise](const Value& input) {
      const double unit = exercise.unit == Unit::one ? 1 : largest_number(input);
      return Sameness{exercise.tolerance, unit, exercise.any_order};
    };
    const auto& along = exercise.along;
    sheet.curve = {along.name, along.from, along.to, put(along), along.number};
    return sheet;
  }

 private:
  using Input = typename Exercise<Signature>::Input;

  static Input tuple(const Value& value) {
    Input input;
    from_value(value, input);
    return input;
  }
  static std::function<Value(const Value&, double)> put(const typename Exercise<Signature>::Along& along) {
    return [change = along.put](const Value& value, double at) {
      Input input = tuple(value);
      change(input, at);
      return to_value(input);
    };
  }
  static std::string told_tolerance(const Exercise<Signature>& exercise) {
    const std::string number = shown(to_value(exercise.tolerance));
    return number + (exercise.unit == Unit::one ? "" : " of the largest number of the input");
  }
};

}  // namespace workbook
