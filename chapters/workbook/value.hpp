#pragma once
#include <string>
#include <vector>

/// How answers are checked: \see docs/pages/workbook.md
namespace workbook {

/// What goes into an exercise or comes out of it, whatever its type: a number, or a tree of numbers.
struct Value {
  enum class Kind { nothing, truth, whole, number, group, list };
  Kind kind = Kind::nothing;
  double number = 0;         ///< of a number, a whole one, a truth (0 or 1)
  std::vector<Value> parts;  ///< of a group, whose length is its type's, or of a list
};

/// On one line, every number to its last bit.
std::string written(const Value& value);
/// The inverse of `written`. \throws std::invalid_argument if the line is none.
Value read_value(const std::string& line);

/// For a reader: shortest digits, (1, 2, 3) for a group, [1, 2] for a list, "nothing".
std::string shown(const Value& value);
/// The same value with its numbers rounded to multiples of a power of ten that is below `step`.
Value rounded(const Value& value, double step);

/// The largest of all numbers in it, without signs.
double largest_number(const Value& value);
/// The numbers in it, from left to right.
std::vector<double> numbers_in(const Value& value);
/// Is there one that is not a number?
bool has_nan(const Value& value);

/// When two answers are the same.
struct Sameness {
  double tolerance = 0;    ///< of a number, relative to the larger of the two, or of `unit`
  double unit = 1;         ///< what is small beside it does not matter
  bool any_order = false;  ///< of the list that the answer is
};
bool same(const Value& a, const Value& b, const Sameness& sameness);

}  // namespace workbook
