#include "first_contact/program/progress_line.hpp"

#if __has_include(<unistd.h>)
#include <unistd.h>
#else
#include <io.h>
#endif

#include <cstdio>
#include <utility>

#include "first_contact/files/printable.hpp"

namespace first_contact::program {

namespace {

bool is_terminal() {
#if __has_include(<unistd.h>)
  return isatty(STDERR_FILENO) != 0;
#else
  return _isatty(_fileno(stderr)) != 0;
#endif
}

}  // namespace

ProgressLine::ProgressLine(std::string name) : name_(printable(std::move(name), 60)), seen_(is_terminal()) {}

ProgressLine::~ProgressLine() {
  if (seen_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double part) const {
  if (seen_) std::fprintf(stderr, "\r%s: %3.0f %%", name_.c_str(), 100 * part);
}

}  // namespace first_contact::program
