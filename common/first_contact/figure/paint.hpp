#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "first_contact/figure/palette.hpp"

namespace first_contact::figure {

/// How a line is drawn; the width in points.
struct Pen {
  Colour colour = colour::ink;  ///< of the palette
  double width = 1.4;           ///< in points
  bool dashed = false;          ///< for what is hidden or moved out
};

/// How an area is filled. Shaded: lit by the scene's light, for the faces of a solid; else flat.
struct Fill {
  Colour colour = colour::floor;              ///< of the palette
  double opacity = 1;                         ///< from 0, clear as air, to 1
  bool shaded = false;                        ///< lit by the scene's light
  std::optional<Pen> outline = std::nullopt;  ///< none if it is empty
};

/// White on a dark page too: the paper's own white becomes dark there.
inline constexpr std::uint32_t light_colour = 0xFFFFFE;

/// A colour under a light that falls at an angle whose cosine is given: ambient, diffuse and a soft
/// highlight.
std::uint32_t lit(std::uint32_t rgb, double cosine);

/// A colour as an expression of the script: the palette's name, so that it follows the theme ...
std::string flat(const Colour& colour, double opacity);
/// ... or a shade of it.
std::string shade(std::uint32_t rgb, double opacity);

/// The style of a filled polygon. Faces of a solid are drawn with a hairline of their own colour, or the page
/// would shine through between neighbours.
std::string area(const std::string& colour, bool hairline);

/// The style of a line.
std::string stroke(const Pen& pen);

}  // namespace first_contact::figure
