// gnuplot's SVG, shortened: what is drawn stays the same.
#include "first_contact/figure/short_svg.hpp"

#include "catch.hpp"

using first_contact::figure::short_svg;

namespace {

const std::string style = "<g fill=\"none\" color=\"black\" stroke-width=\"1.00\">\n";

std::string plot(const std::string& content) {
  return "\t<g id=\"gnuplot_plot_7\" ><title>gnuplot_plot_7</title>\n" + style + content + "</g>\n\t</g>\n";
}

std::string polygons(const std::string& elements) { return "\t<g stroke='none'>\n" + elements + "\t</g>\n"; }

const std::string triangle =
    "\t\t<polygon fill = '#ff0000' fill-opacity='0.30'  points = '10.00,20.00 12.51,20.00 11.00,18.50 '/>\n";

}  // namespace

TEST_CASE("A polygon alone in its groups becomes a path that keeps its colour and its opacity") {
  CHECK(short_svg(plot(polygons(triangle))) ==
        "<path stroke='none' fill = '#ff0000' fill-opacity='0.30'  d='m10 20l2.5 0-1.5-1.5z'/>\n");
}

TEST_CASE("A plot that draws nothing leaves nothing") { CHECK(short_svg(plot("")).empty()); }

TEST_CASE("A line needs the width that its group tells, and keeps the group") {
  const std::string line = "\t<path stroke='#000000'  d='M1.00,2.00 L3.00,4.00  '/>\n";
  CHECK(short_svg(plot(line)) == "\t<g id=\"gnuplot_plot_7\" >\n" + style + line + "</g>\n\t</g>\n");
}

TEST_CASE("Two polygons, or a polygon with its outline, keep their group, and no outline is added") {
  const std::string outline = "\t<path stroke='#000000'  d='M1.00,2.00 L3.00,4.00  '/>\n";
  CHECK(short_svg(plot(polygons(triangle + triangle))).find(triangle + triangle) != std::string::npos);
  const std::string outlined = short_svg(plot(polygons(triangle) + outline));
  CHECK(outlined.find(style + "<path stroke='none'") != std::string::npos);
  CHECK(outlined.find(outline + "</g>") != std::string::npos);
}

TEST_CASE("Four polygons of one colour with their outlines become one path, each told from the one before") {
  const std::string four = triangle + triangle + triangle + triangle;
  const std::string svg =
      short_svg(plot("\t<g stroke='none'>\n" + four + "\t</g>\n\t<path stroke='#ff0000' d='M1,2'/>"));
  CHECK(svg.find("d='m10 20l2.5 0-1.5-1.5zm0 0l2.5 0-1.5-1.5z") != std::string::npos);
  CHECK(svg.find("M1,2") == std::string::npos);
}

TEST_CASE("What is no plot of gnuplot's passes unchanged") {
  CHECK(short_svg("").empty());
  CHECK(short_svg("<svg><g stroke='none'></svg>") == "<svg><g stroke='none'></svg>");
}
