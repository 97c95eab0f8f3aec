#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "first_contact/figure/figure.hpp"

namespace first_contact::figure {

/// Has gnuplot draw one picture (svg, png, pdf or gif) from a script, in the script's folder; an svg is made
/// to follow the reader's theme. What is missing, gnuplot itself or the letters of a picture, is told on
/// standard error, once in a program.
/// \return all bytes of the picture; nothing if gnuplot is not installed
/// \throws std::runtime_error with gnuplot's status and words if gnuplot fails, or complains, or draws no
///     whole picture.
std::optional<std::string> render(const Studio& studio, const std::filesystem::path& script,
                                  const std::string& format);

/// Does the picture have its end? What is cut short, or empty, has not.
bool is_whole(const std::string& picture, const std::string& format);

}  // namespace first_contact::figure
