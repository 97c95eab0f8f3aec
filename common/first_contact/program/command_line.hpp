#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "first_contact/program/language.hpp"

namespace first_contact::program {

/// The language that the words of a command line ask for by `--lang`, whatever else is wrong with them.
Language language_asked(int argc, const char* const* argv);

/// The words of a command line as CLI11 wants them, the last one first. `--p1 -1,8`: a value that begins with
/// a minus sign is joined to its option, so that it is never taken for another option. And `--out --json` is
/// refused, where CLI11 alone would take `--json` for the folder, as it would for that of `--out ''`.
/// \throws Refused if a word is neither an option nor the value of one, or if an option that needs a value is followed by
/// another option, by nothing or by an empty value, or is given twice.
std::vector<std::string> arguments_of(const CLI::App& line, int argc, const char* const* argv);

/// What is written must not take the place of another file of the same line. Such options are known by their letters:
/// FILE or IN.csv is read, OUT.csv or OUT.json is written.
/// \throws Refused if one that is written is the same file as another.
void require_different_files(const CLI::App& line);

/// ... and it must be possible to write it: known before anything is done, and so before another file is written.
/// \throws Refused if one cannot be written, as far as can be known before.
void require_writable_files(const CLI::App& line);

}  // namespace first_contact::program
