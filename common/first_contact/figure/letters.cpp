#include "first_contact/figure/letters.hpp"

#include <system_error>

#include "first_contact/figure/child_process.hpp"

namespace first_contact::figure {

namespace {

// Pictures of dots are drawn with fontconfig's fonts: its own program knows them.
bool has_font(const std::string& name) {
  const auto program = process::search_path("fc-list");
  if (program.empty()) return true;
  std::error_code error;
  process::child list(program, process::args = {"-q", name},
                      process::std_in<process::null, process::std_out> process::null,
                      process::std_err > process::null, error);
  if (error) return true;
  list.wait(error);
  return error || list.exit_code() != 1;
}

}  // namespace

std::string missing_letters(bool chinese) {
  const std::string font = chinese ? "Noto Sans CJK TC" : "DejaVu Serif";
  if (has_font(font)) return "";
  return "the font " + font +
         " was not found, so labels may be missing or look otherwise; install the package " +
         (chinese ? "fonts-noto-cjk" : "fonts-dejavu-core");
}

}  // namespace first_contact::figure
