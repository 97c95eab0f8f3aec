#pragma once
#include <string>

namespace first_contact::figure {

/// The SVG that gnuplot made, said in fewer bytes and drawn the same: without the groups that draw nothing
/// and without titles such as "gnuplot_plot_1", which a browser would show under the pointer; a single
/// polygon without the three groups about it; the polygons of a mesh as one path, to a tenth of a point.
/// SVGO would say it in fewer bytes still, but needs Node.js, without which a chapter must be able to draw.
std::string short_svg(const std::string& svg);

}  // namespace first_contact::figure
