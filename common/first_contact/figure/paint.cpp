#include "first_contact/figure/paint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace first_contact::figure {

std::uint32_t lit(std::uint32_t rgb, double cosine) {
  const double diffuse = 0.58 + 0.42 * std::max(0.0, cosine);
  const double gloss = 0.22 * std::pow(std::max(0.0, cosine), 24);
  const auto channel = [&](unsigned shift) {
    const double value = (rgb >> shift & 255U) * diffuse;
    return static_cast<std::uint32_t>(std::lround(value + (255 - value) * gloss)) << shift;
  };
  return channel(16) | channel(8) | channel(0);
}

std::string flat(const Colour& colour, double opacity) {
  if (opacity >= 1) return std::string(colour.name);
  std::ostringstream out;
  out << "fade(" << colour.name << "," << opacity << ")";
  return out.str();
}

std::string shade(std::uint32_t rgb, double opacity) {
  const auto clear = static_cast<std::uint32_t>(std::lround((1 - opacity) * 255));
  char text[24];
  std::snprintf(text, sizeof text, "tone(0x%02X%06X)", clear, rgb);
  return text;
}

std::string area(const std::string& colour, bool hairline) {
  std::string style = "filledcurves closed fc rgb " + colour;
  return style + (hairline ? " fs solid border lc rgb " + colour + " lw 1.1" : " fs solid noborder");
}

std::string stroke(const Pen& pen) {
  std::ostringstream out;
  out << "lc rgb " << pen.colour.name << " lw " << pen.width << (pen.dashed ? " dt (6,5)" : " dt solid");
  return out.str();
}

}  // namespace first_contact::figure
