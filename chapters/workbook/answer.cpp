// A student's answer as a program: the launcher says which file.
#include "task.hpp"
#include ANSWER
#include "workbook/serve.hpp"

#undef main

// Whether it takes its arguments by value or by reference, and what it gives, is the student's own affair.
template <class>
struct Asked;
template <class Result, class... Arguments>
struct Asked<Result(Arguments...)> {
  static Result answer(Arguments... arguments) { return EXERCISE_FUNCTION(arguments...); }
};

int main() { return workbook::serve<Signature>(Asked<Signature>::answer); }
