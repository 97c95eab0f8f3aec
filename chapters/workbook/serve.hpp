#pragma once
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "workbook/convert.hpp"

/// The student's side: a process of its own that answers one line by another, until there are no more. It
/// prints where it
/// likes; answers go through a file of their own, so that nothing else is taken for one.
namespace workbook {

constexpr int asks = 3, answers = 4;  // the numbers of the files that the judge opens

/// Reads one line, without its end; false at the end of all.
inline bool read_line(std::FILE* file, std::string& line) {
  line.clear();
  for (int letter = std::fgetc(file); letter != EOF; letter = std::fgetc(file)) {
    if (letter == '\n') return true;
    line += static_cast<char>(letter);
  }
  return false;
}

/// "= answer", "! what was thrown", "m" if there is no more memory.
template <class Signature>
std::string answer_line(Signature* function, const std::string& line) {
  try {
    return "= " + written(answer_of(function, read_value(line)));
  } catch (const std::bad_alloc&) {
    return "m";
  } catch (const std::exception& error) {
    return std::string("! ") + error.what();
  } catch (...) {
    return "! something that is no std::exception";
  }
}

template <class Signature>
int serve(Signature* function) {
  std::FILE* const in = fdopen(asks, "r");
  std::FILE* const out = fdopen(answers, "w");
  if (!in || !out) return std::fputs("This program is asked by ./course check alone.\n", stderr), 2;
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  for (std::string line; read_line(in, line);) {
    std::string answer = answer_line(function, line);
    for (char& letter : answer)
      if (letter == '\n') letter = ' ';
    std::fflush(stdout);
    std::fprintf(out, "%s\n", answer.c_str());
    std::fflush(out);
  }
  return 0;
}

}  // namespace workbook
