#include "first_contact/figure/render.hpp"

#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "first_contact/figure/child_process.hpp"
#include "first_contact/figure/style.hpp"

namespace first_contact::figure {

namespace {

namespace fs = std::filesystem;

// gnuplot counts the pictures of an animation aloud, "25 frames in animation sequence": no complaint, all
// else is one.
bool is_count_of_frames(const std::string& said) {
  constexpr std::string_view rest = " frames in animation sequence";
  const std::size_t number = said.find_first_not_of("0123456789");
  return number != 0 && number != std::string::npos && said.substr(number, rest.size()) == rest &&
         said.find_first_not_of(" \n", number + rest.size()) == std::string::npos;
}

// A text as gnuplot takes it literally.
std::string quoted(const std::string& text) {
  std::string literal = "'";
  for (const char letter : text) literal += letter == '\'' ? "''" : std::string(1, letter);
  return literal + "'";
}

// What gnuplot says of itself goes to standard error, and its status may be 0 all the same: both count.
void run_gnuplot(const std::string& program, const Studio& studio, const fs::path& script,
                 const std::string& format) {
  process::ipstream complaints;
  process::environment environment = boost::this_process::environment();
  environment["LC_ALL"] = "C.UTF-8";  // else its conversion of a degree sign fails
  std::vector<std::string> arguments{"-e", "format='" + format + "'", "-e",
                                     "theme='" + (format == "svg" ? "light" : studio.theme) + "'"};
  if (!studio.own.empty())
    arguments.insert(arguments.end(), {"-e", "own=" + quoted(fs::absolute(studio.own).string())});
  arguments.push_back(script.filename().string());
  process::child gnuplot(program, process::args = arguments,
                         process::start_dir = script.parent_path().string(), process::std_out > process::null,
                         process::std_err > complaints, environment);
  const std::string said{std::istreambuf_iterator<char>(complaints), {}};
  gnuplot.wait();
  if (gnuplot.exit_code() != 0 || !(said.empty() || is_count_of_frames(said)))
    throw std::runtime_error("gnuplot, drawing " + script.string() + ", ended with status " +
                             std::to_string(gnuplot.exit_code()) + " and said: " + said);
}

void theme_in_place(const fs::path& picture) {
  std::ostringstream svg;
  svg << std::ifstream(picture).rdbuf();
  std::ofstream(picture) << themed(svg.str());
}

void explain_once(const std::string& gnuplot) {
  static bool explained = false;
  if (!std::exchange(explained, true))
    std::cerr << "note: '" << gnuplot << "' was not found, so there are scripts (.gp) but no pictures; "
              << "install the package gnuplot-nox to draw them\n";
}

}  // namespace

void render(const Studio& studio, const fs::path& script, const std::string& format) {
  const std::string program = process::search_path(studio.gnuplot).string();
  if (program.empty()) return explain_once(studio.gnuplot);
  const fs::path whole = fs::absolute(script);
  run_gnuplot(program, studio, whole, format);
  if (format == "svg") theme_in_place(fs::path(whole).replace_extension("svg"));
}

}  // namespace first_contact::figure
