#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// Figures through gnuplot. A figure is a script of its own, its data inside, and the pictures drawn from it.

namespace first_contact::figure {

/// Where figures go and how they are drawn: the same for all figures of one run of a program.
struct Studio {
  std::filesystem::path folder = ".";          ///< it is made if it does not exist
  std::vector<std::string> formats = {"svg"};  ///< of svg, png, pdf
  std::string theme = "light";      ///< light, dark or grey, for png and pdf; an svg follows its reader
  bool chinese = false;             ///< labels in Traditional Chinese: another font
  std::string gnuplot = "gnuplot";  ///< the program that draws: a name, or a path
  double patience = 120;            ///< seconds that it may take for a picture
  std::string own;                  ///< a file of gnuplot commands read after the house style, or empty
};

/// The size of a picture in points (1/96 inch).
struct Size {
  int width = 720;   ///< from left to right
  int height = 500;  ///< from top to bottom
};

/// Rows of numbers; an empty row is a blank line, which parts two curves.
using Table = std::vector<std::vector<double>>;

/// One figure: write its commands to `script()`, then `draw()`.
///
///     Figure figure(studio, "figure-13");
///     figure.data("path", rows);
///     figure.script() << "plot $path with lines ls 1\n";
///     figure.draw();
class Figure {
 public:
  /// Begins the script `folder/name.gp` with the house style.
  Figure(const Studio& studio, std::string name, Size size = {});
  Figure(const Figure&) = delete;
  Figure& operator=(const Figure&) = delete;
  ~Figure();

  /// The gnuplot commands.
  std::ostream& script();
  /// The named data block $name, with that many significant digits a number.
  void data(std::string_view name, const Table& rows, int digits = 9);
  /// Closes the script and draws its pictures. Where gnuplot is not installed the script is all there is, and
  /// one line on standard error says so, once.
  /// \throws FileError if a file cannot be written.
  /// \throws std::runtime_error with gnuplot's own words if it fails.
  void draw();
  /// Closes the script and has gnuplot draw it in that format; nothing if gnuplot is not installed.
  /// \throws what `draw` throws.
  std::optional<std::string> picture(const std::string& format);
  /// Writes a picture beside the script.
  /// \throws FileError if it cannot be written.
  void keep(const std::string& format, const std::string& picture) const;

 private:
  void close();

  struct Session;
  const Studio studio_;
  const std::string name_;
  std::unique_ptr<Session> session_;
};

}  // namespace first_contact::figure
