#include "first_contact/figure/render.hpp"

#include <array>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "first_contact/figure/gnuplot.hpp"
#include "first_contact/figure/letters.hpp"
#include "first_contact/figure/style.hpp"
#include "first_contact/files/input.hpp"
#include "first_contact/files/printable.hpp"

namespace first_contact::figure {

namespace {

namespace fs = std::filesystem;

void tell_once(const std::string& note) {
  static std::set<std::string> told;
  if (told.insert(note).second) std::cerr << "note: " << note << '\n';
}

// What tools and what the user's eyes find at the end of a picture.
std::string_view last_bytes(const std::string& format) {
  using namespace std::string_view_literals;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> ends{
      {{"svg", "</svg>"}, {"png", "IEND\xAE\x42\x60\x82"}, {"pdf", "%%EOF"}, {"gif", "\0;"sv}}};
  for (const auto& [name, end] : ends)
    if (name == format) return end;
  return "";
}

}  // namespace

bool is_whole(const std::string& picture, const std::string& format) {
  const std::size_t end = picture.find_last_not_of(" \r\n") + 1;
  return !picture.empty() && std::string_view(picture).substr(0, end).ends_with(last_bytes(format));
}

std::optional<std::string> render(const Studio& studio, const fs::path& script, const std::string& format) {
  const fs::path program = find_gnuplot(studio.gnuplot);
  if (program.empty()) {
    tell_once("'" + printable(studio.gnuplot) +
              "' was not found, so there are scripts (.gp) but no pictures; " +
              "install the package gnuplot-nox to draw them");
    return std::nullopt;
  }
  const std::string missing = format == "svg" ? "" : missing_letters(studio.chinese);
  if (!missing.empty()) tell_once(missing);
  run_gnuplot(program, studio, script, format);
  const fs::path picture = fs::path(script).replace_extension(format);
  std::error_code ignored;
  const std::string drawn = fs::exists(picture, ignored) ? read_file(picture) : "";
  if (!is_whole(drawn, format))
    throw std::runtime_error(program.string() + " ended with status 0 but drew no whole " +
                             picture.filename().string() + ": must be a gnuplot that works, with room in " +
                             printable(picture.parent_path().string()));
  return format == "svg" ? themed(drawn) : drawn;
}

}  // namespace first_contact::figure
