#pragma once
#include <ostream>
#include <string>

#include "workbook/verdict.hpp"

namespace workbook {

/// The head of a file of a known answer: its lines "// Key: words", with what goes on in the next lines.
std::map<std::string, std::string> head_of(const std::string& file);

/// What a student reads.
void tell(std::ostream& out, const Sheet& sheet, const Verdict& verdict);

/// The verdict in one word: right, known:NAME, constant, wrong, nan, crash, endless, exception, ended,
/// memory.
std::string word_for(const Verdict& verdict);

}  // namespace workbook
