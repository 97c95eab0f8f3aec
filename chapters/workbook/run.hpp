#pragma once
#include <vector>

#include "workbook/verdict.hpp"

namespace workbook {

/// The program that judges one exercise:
///   judge [--figure FILE.gp] [--brief] [--seconds N] COMMAND...  asks the student's program; status 0 if it
/// is right, 1 if not
///   judge --prove                                    asks what is known: the stub, wrong answers, solutions
int run(const Sheet& sheet, const std::vector<Known>& known, int argc, char** argv);

/// Does each known answer draw what it should? Tells what does not, and returns how many.
int prove(const Sheet& sheet, const std::vector<Known>& known);

}  // namespace workbook
