#include "first_contact/figure/animation.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace first_contact::figure {

namespace {

// Pictures are as precise as eyes are: a tenth of a point, a thousandth of the time.
std::string rounded(double value, int digits = 1) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  std::string number = text;
  if (number.find('.') != std::string::npos) number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number == "-0" ? "0" : number;
}

std::string hexadecimal(const Colour& colour) {
  char text[16];
  std::snprintf(text, sizeof text, "#%06x", colour.light);
  return text;
}

std::string circle(const Eigen::Vector2d& at, double radius, const Colour& colour) {
  return "<circle cx=\"" + rounded(at.x()) + "\" cy=\"" + rounded(at.y()) + "\" r=\"" + rounded(radius) +
         "\" fill=\"" + hexadecimal(colour) + "\"";
}

std::string corners(const Diagram& diagram, const Outline& outline) {
  std::string all;
  for (const Eigen::Vector2d& corner : outline.corners) {
    const Eigen::Vector2d p = diagram.pixel(corner);
    all += (all.empty() ? "" : " ") + rounded(p.x()) + "," + rounded(p.y());
  }
  return all;
}

void keep(const std::vector<Moment>& all, std::size_t first, std::size_t last, double tolerance,
          std::vector<Moment>& kept) {
  double worst = 0;
  std::size_t split = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double part = (all[i].time - all[first].time) / (all[last].time - all[first].time);
    const double off = ((1 - part) * all[first].at + part * all[last].at - all[i].at).norm();
    if (off > worst) {
      worst = off;
      split = i;
    }
  }
  if (worst > tolerance) {
    keep(all, first, split, tolerance, kept);
    keep(all, split, last, tolerance, kept);
  } else {
    kept.push_back(all[last]);
  }
}

}  // namespace

Eigen::Vector2d Diagram::pixel(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d part = (p - range.min()).cwiseQuotient(range.sizes());
  return {size.width * (left + (right - left) * part.x()),
          size.height * (1 - bottom - (top - bottom) * part.y())};
}

double Diagram::unit_y() const { return size.height * (top - bottom) / range.sizes().y(); }

std::string Diagram::commands() const {
  std::ostringstream out;
  out << "set lmargin at screen " << left << "\nset rmargin at screen " << right << "\nset bmargin at screen "
      << bottom << "\nset tmargin at screen " << top << "\nset xrange [" << range.min().x() << ":"
      << range.max().x() << "]\nset yrange [" << range.min().y() << ":" << range.max().y() << "]\n";
  return out.str();
}

std::vector<Moment> sparse(const std::vector<Moment>& moments, double tolerance) {
  if (moments.size() < 3) return moments;
  std::vector<Moment> kept{moments.front()};
  keep(moments, 0, moments.size() - 1, tolerance, kept);
  return kept;
}

Animation::Animation(const Diagram& diagram, double duration, double seconds)
    : diagram_(diagram), duration_(duration), seconds_(seconds) {}

std::string Animation::timing() const {
  return " dur=\"" + rounded(seconds_, 3) + "s\" repeatCount=\"indefinite\"";
}

std::string Animation::path(const std::vector<Moment>& moments) const {
  std::string line;
  for (const Moment& moment : moments) {
    const Eigen::Vector2d p = diagram_.pixel(moment.at);
    line += (line.empty() ? "M" : "L") + rounded(p.x()) + "," + rounded(p.y());
  }
  return line;
}

// Nothing before `from`, then `opacity`, and nothing again from `until` on.
std::string Animation::appearing(double from, double until, double opacity) const {
  const double end = std::min(until, duration_);
  std::string values = "0;" + rounded(opacity, 2), times = "0;" + rounded(from / duration_, 4);
  if (from <= 0) {
    values = rounded(opacity, 2);
    times = "0";
  }
  if (end < duration_) {
    values += ";0";
    times += ";" + rounded(end / duration_, 4);
  }
  return "<animate attributeName=\"opacity\" calcMode=\"discrete\" values=\"" + values + "\" keyTimes=\"" +
         times + "\"" + timing() + "/>";
}

void Animation::ball(const std::vector<Moment>& moments, double radius, const Colour& colour) {
  std::vector<Moment> pixels;
  for (const Moment& moment : moments)
    if (moment.time <= duration_) pixels.push_back({moment.time, diagram_.pixel(moment.at)});
  pixels = sparse(pixels, 0.2);
  if (pixels.empty()) return;
  if (pixels.back().time < duration_) pixels.push_back({duration_, pixels.back().at});
  std::string values, times;
  for (const Moment& pixel : pixels) {
    values += (values.empty() ? "" : ";") + rounded(pixel.at.x()) + "," + rounded(pixel.at.y());
    times += (times.empty() ? "" : ";") + rounded(pixel.time / duration_, 4);
  }
  const double size = radius * diagram_.unit_y();
  moving_ += circle({0, 0}, size, colour) + " transform=\"translate(" + rounded(pixels.back().at.x()) + "," +
             rounded(pixels.back().at.y()) + ")\"" +
             "><animateTransform attributeName=\"transform\" type=\"translate\"" + timing() + " keyTimes=\"" +
             times + "\" values=\"" + values + "\"/></circle>\n";
  still_ += circle(pixels.back().at, size, colour) + "/>\n";
}

// The path shows as far as a growing window lets it: its x is a steady clock where x grows with time.
void Animation::trace(const std::vector<Moment>& moments, const Colour& colour, double width) {
  std::vector<Moment> shown;
  for (const Moment& moment : moments)
    if (moment.time <= duration_) shown.push_back(moment);
  if (shown.empty()) return;
  const double begin = diagram_.pixel(shown.front().at).x(), end = diagram_.pixel(shown.back().at).x();
  const std::string line = "<path d=\"" + path(sparse(shown, 0.2 / diagram_.unit_y())) +
                           "\" fill=\"none\" stroke=\"" + hexadecimal(colour) + "\" stroke-width=\"" +
                           rounded(width) + "\" stroke-linejoin=\"round\"/>\n";
  moving_ += "<clipPath id=\"passed\"><rect x=\"" + rounded(begin) + "\" y=\"0\" height=\"" +
             std::to_string(diagram_.size.height) +
             "\" width=\"0\"><animate attributeName=\"width\" from=\"0\" to=\"" + rounded(end - begin) +
             "\"" + timing() + "/></rect></clipPath>\n<g clip-path=\"url(#passed)\">" + line + "</g>\n";
  still_ += line;
}

void Animation::stamp(const Moment& moment, double radius, const Colour& colour, double opacity) {
  const std::string disc = circle(diagram_.pixel(moment.at), radius * diagram_.unit_y(), colour);
  moving_ += disc + " opacity=\"0\">" + appearing(moment.time, duration_, opacity) + "</circle>\n";
  still_ += disc + " opacity=\"" + rounded(opacity, 2) + "\"/>\n";
}

void Animation::area(const std::vector<Outline>& outlines, const Colour& fill) {
  shape(
      outlines, "polygon",
      "fill=\"" + hexadecimal(fill) + "\" stroke=\"" + hexadecimal(colour::ink) + "\" stroke-width=\"1.2\"");
}

void Animation::line(const std::vector<Outline>& outlines, const Colour& colour) {
  shape(outlines, "polyline", "fill=\"none\" stroke=\"" + hexadecimal(colour) + "\" stroke-width=\"1.2\"");
}

// What is not seen keeps the corners that it had, or will have, so that nothing moves but what is seen.
void Animation::shape(std::vector<Outline> outlines, const std::string& element, const std::string& style) {
  const auto seen = [](const Outline& outline) { return !outline.corners.empty(); };
  const auto first = std::find_if(outlines.begin(), outlines.end(), seen);
  if (first == outlines.end()) return;
  std::string points = corners(diagram_, *first), values, times, shown;
  if (outlines.back().time < duration_) outlines.push_back({duration_, outlines.back().corners});
  for (const Outline& outline : outlines) {
    const std::string next = values.empty() ? "" : ";";
    if (seen(outline)) points = corners(diagram_, outline);
    values += next + points;
    times += next + rounded(outline.time / duration_, 5);
    shown += next + (seen(outline) ? "1" : "0");
  }
  const std::string base = "<" + element + " points=\"" + points + "\" " + style;
  const std::string at = timing() + " keyTimes=\"" + times + "\" values=\"";
  moving_ += base + "><animate attributeName=\"points\"" + at + values + "\"/>";
  if (shown.find('0') != std::string::npos)
    moving_ += "<animate attributeName=\"opacity\" calcMode=\"discrete\"" + at + shown + "\"/>";
  moving_ += "</" + element + ">\n";
  if (seen(outlines.back())) still_ += base + "/>\n";
}

void Animation::text(const std::string& words, const Eigen::Vector2d& at, double from, double until,
                     const Colour& colour, bool chinese) {
  const Eigen::Vector2d p = diagram_.pixel(at);
  const std::string font =
      chinese ? "Noto Sans CJK TC, PingFang TC, sans-serif" : "DejaVu Serif, Georgia, serif";
  moving_ += "<text x=\"" + rounded(p.x()) + "\" y=\"" + rounded(p.y()) + "\" font-family=\"" + font +
             "\" font-size=\"16\" fill=\"" + hexadecimal(colour) + "\" opacity=\"0\">" + words +
             appearing(from, until, 1) + "</text>\n";
}

std::string Animation::over(std::string svg) const {
  const std::string all =
      "<style>.still{display:none}@media (prefers-reduced-motion:reduce){.still{display:inline}"
      ".moving{display:none}}</style>\n<g class=\"moving\">\n" +
      moving_ + "</g>\n<g class=\"still\">\n" + still_ + "</g>\n";
  const std::size_t end = svg.rfind("</svg>");
  if (end != std::string::npos) svg.insert(end, all);
  return svg;
}

Studio svg_only(Studio studio) {
  const bool svg = std::find(studio.formats.begin(), studio.formats.end(), "svg") != studio.formats.end();
  studio.formats = svg ? std::vector<std::string>{"svg"} : std::vector<std::string>{};
  return studio;
}

void draw_animated(const Studio& studio, Figure& figure, const Animation& animation) {
  if (svg_only(studio).formats.empty()) return figure.draw();
  const auto svg = figure.picture("svg");
  if (!svg) return;  // without gnuplot there is the script alone
  figure.keep("svg", animation.over(*svg));
  figure.keep("gif", figure.picture("gif").value());
}

std::string gif_terminal(const std::string& name, Size size, int delay, bool chinese) {
  std::ostringstream out;
  out << "if (format eq \"gif\") {\n  set terminal gif animate delay " << delay
      << " loop 0 optimize enhanced size " << size.width << "," << size.height << " font \""
      << (chinese ? "Noto Sans CJK TC" : "DejaVu Serif")
      << ",13\" background rgb \"#ffffff\"\n  set output \"" << name << ".gif\"\n}\n";
  return out.str();
}

}  // namespace first_contact::figure
