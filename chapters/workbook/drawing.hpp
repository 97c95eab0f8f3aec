#pragma once
#include <string>

#include "workbook/verdict.hpp"

namespace workbook {

/// Writes a gnuplot script with its data inside: the right answer and the student's, while one number of the
/// input
/// changes. \param input  in which the others stay  \param file  PATH.gp, which draws PATH.svg
void draw(const Sheet& sheet, const Value& input, const Ask& ask, const std::string& file);

}  // namespace workbook
