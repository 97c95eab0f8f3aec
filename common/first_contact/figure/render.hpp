#pragma once
#include <filesystem>
#include <string>

#include "first_contact/figure/figure.hpp"

namespace first_contact::figure {

/// Has gnuplot draw one picture (svg, png, pdf or gif) from a script, beside it; an svg is made to follow the
/// reader's theme. If gnuplot is not installed it says so on standard error, once in a program, and returns.
/// \throws std::runtime_error with gnuplot's status and words if gnuplot fails, or complains.
void render(const Studio& studio, const std::filesystem::path& script, const std::string& format);

}  // namespace first_contact::figure
