#pragma once
#include <string>

namespace first_contact::figure {

/// The opening of every script: format and theme (both can be set from gnuplot's command line), the palette,
/// fonts, line and arrow styles.
/// \param name of the picture, without its ending
/// \param width, height in points.
std::string style(const std::string& name, int width, int height, bool chinese);

/// The SVG that gnuplot made, following the reader's light or dark theme: each colour of the palette gets a
/// rule for dark pages, and the fonts a fallback.
std::string themed(std::string svg);

}  // namespace first_contact::figure
