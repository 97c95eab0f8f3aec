#include "first_contact/figure/style.hpp"

#include <cstdio>
#include <sstream>

#include "first_contact/figure/palette.hpp"
#include "first_contact/figure/short_svg.hpp"

namespace first_contact::figure {

namespace {

std::string hexadecimal(std::uint32_t rgb, const char* form) {
  char text[16];
  std::snprintf(text, sizeof text, form, rgb);
  return text;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// gnuplot's two ways to write a colour: numbers padded to three places for lines and fills, bare ones for
// text.
std::string as_gnuplot_writes(std::uint32_t rgb, const char* form) {
  char text[32];
  std::snprintf(text, sizeof text, form, rgb >> 16 & 255U, rgb >> 8 & 255U, rgb & 255U);
  return text;
}

std::string palette_of(bool dark) {
  std::string lines;
  for (const Colour& colour : colour::all)
    lines += std::string("  ") + std::string(colour.name) + " = " +
             hexadecimal(dark ? colour.dark : colour.light, "0x%06X") + "\n";
  return lines;
}

// What a style of one's own may change: these, and the palette above.
std::string own_style(bool chinese) {
  std::ostringstream out;
  out << "\n# -e \"own='FILE'\" reads gnuplot commands of your own here: they may set these and the "
         "colours.\n"
      << "font = \"" << (chinese ? "Noto Sans CJK TC" : "DejaVu Serif")
      << "\"; letters = 1.0; magnify = 1.0\n"
      << "if (exists(\"own\")) load own\n";
  return out.str();
}

constexpr const char* tones = R"(
# fade(c, a): colour c with opacity a.  tone(c): a shaded colour, in grey if the theme is.
fade(c, a) = c + int((1 - a) * 255 + 0.5) * 16777216
luminance(c) = int(0.299 * (c / 65536 & 255) + 0.587 * (c / 256 & 255) + 0.114 * (c & 255))
tone(c) = theme eq "grey" ? (c & 0xFF000000) + luminance(c & 0xFFFFFF) * 65793 : c
if (theme eq "grey") {
  PAPER = 0xFFFFFF; INK = 0x222222
  array hues[13] = [GREY, PALE, BLUE, SKY, GREEN, RED, ORANGE, AMBER, PINK, YELLOW, FLOOR, SHADOW, MIST]
  do for [i = 1:13] { hues[i] = tone(hues[i]) }
  GREY = hues[1]; PALE = hues[2]; BLUE = hues[3]; SKY = hues[4]; GREEN = hues[5]; RED = hues[6]
  ORANGE = hues[7]; AMBER = hues[8]; PINK = hues[9]; YELLOW = hues[10]; FLOOR = hues[11]; SHADOW = hues[12]; MIST = hues[13]
}
)";

constexpr const char* lines_and_arrows = R"(
set encoding utf8
set minussign
set border 3 lw 1 lc rgb INK
set tics nomirror out textcolor rgb INK scale 0.6
set xlabel textcolor rgb INK
set ylabel textcolor rgb INK
set title textcolor rgb INK
set key textcolor rgb INK
set grid lc rgb PALE lw 0.6 lt 1
unset grid
set style line 1 lc rgb BLUE  lw 2.2
set style line 2 lc rgb RED   lw 2.2
set style line 3 lc rgb GREEN lw 2.2
set style line 4 lc rgb PINK  lw 2.2
set style line 10 lc rgb INK  lw 1.4
set style line 11 lc rgb GREY lw 1.2 dt (6,5)
set style arrow 1 head filled size screen 0.022,18,60 front lt 1 lc rgb RED  lw 2.4
set style arrow 2 head filled size screen 0.022,18,60 front lt 1 lc rgb INK  lw 2.0
set style arrow 3 nohead front lt 1 lc rgb GREY lw 1.2 dt (6,5)
set style arrow 4 nohead front lt 1 lc rgb INK lw 1.4
)";

std::string terminals(const std::string& name, int width, int height) {
  std::ostringstream out;
  const std::string size = std::to_string(width) + "," + std::to_string(height);
  const std::string large =
      "magnify * " + std::to_string(2 * width) + ",magnify * " + std::to_string(2 * height);
  const std::string inches =
      "magnify * " + std::to_string(width / 96.0) + ",magnify * " + std::to_string(height / 96.0);
  out << "if (format eq \"svg\") {\n"
      << "  set terminal svg enhanced size " << size
      << " font font . \",17\" fontscale letters rounded background rgb \"#ffffff\"\n"
      << "} else { if (format eq \"png\") {\n"
      << "  set terminal pngcairo enhanced size " << large
      << " font font . \",17\" fontscale 2 * magnify * letters linewidth 2 * magnify "
         "pointscale 2 * magnify rounded background rgb PAPER\n"
      << "} else {\n"
      << "  set terminal pdfcairo enhanced size " << inches
      << " font font . \",13\" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb "
         "PAPER\n"
      << "} }\n"
      << "set output \"" << name << ".\" . format\n";
  return out.str();
}

}  // namespace

std::string style(const std::string& name, int width, int height, bool chinese) {
  return "# Draws " + name +
         ".svg; with -e \"format='png'\" (or 'pdf') and -e \"theme='dark'\" (or 'grey')\n" +
         "# before the script's name, the other pictures.\n" +
         "if (!exists(\"format\")) format = \"svg\"\nif (!exists(\"theme\")) theme = \"light\"\n" +
         "if (theme eq \"dark\") {\n" + palette_of(true) + "} else {\n" + palette_of(false) + "}" +
         own_style(chinese) + tones + terminals(name, width, height) + lines_and_arrows;
}

std::string themed(std::string svg) {
  std::string dark =
      ":root{color-scheme:light dark}@media (prefers-color-scheme:dark){[color=\"black\"]{color:" +
      hexadecimal(colour::ink.dark, "#%06x") + "}";
  for (const Colour& colour : colour::all) {
    const std::string light = hexadecimal(colour.light, "#%06x");
    const std::string other = hexadecimal(colour.dark, "#%06x");
    replace_all(svg, as_gnuplot_writes(colour.light, "rgb(%3u, %3u, %3u)"), light);
    replace_all(svg, as_gnuplot_writes(colour.light, "rgb(%u,%u,%u)"), light);
    for (const std::string attribute : {"fill", "stroke", "color"})
      dark.append("[")
          .append(attribute)
          .append("=\"" + light + "\"]{")
          .append(attribute)
          .append(":" + other + "}");
  }
  replace_all(svg, " shape-rendering='crispEdges'", "");  // it would draw fills without smooth edges
  svg = short_svg(svg);
  replace_all(svg, "font-family=\"DejaVu Serif\"", "font-family=\"DejaVu Serif, Georgia, serif\"");
  replace_all(svg, "font-family=\"Noto Sans CJK TC\"",
              "font-family=\"Noto Sans CJK TC, PingFang TC, sans-serif\"");
  const std::size_t definitions = svg.find("<defs>");
  if (definitions != std::string::npos) svg.insert(definitions, "<style>" + dark + "}</style>\n");
  return svg;
}

}  // namespace first_contact::figure
