#include "first_contact/figure/short_svg.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "first_contact/files/decimal.hpp"

namespace first_contact::figure {

namespace {

// What stands between two marks, from `at` on, which is moved behind it; nothing if they are not there.
std::string_view between(std::string_view text, std::string_view open, std::string_view close,
                         std::size_t& at) {
  const std::size_t begin = text.find(open, at);
  const std::size_t end = begin == text.npos ? text.npos : text.find(close, begin + open.size());
  if (end == text.npos) return {};
  at = end + close.size();
  return text.substr(begin + open.size(), end - begin - open.size());
}

// A place in a picture, in tenths of a point.
struct Place {
  long x, y;
};

// The number that the text begins with; the text is moved behind it, and behind the mark that ends it.
double next_number(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789eE"), text.size());
  const double number = decimal(text.substr(0, end)).value_or(0);
  text.remove_prefix(std::min(end + 1, text.size()));
  return number;
}

// The next of gnuplot's corners, "12.34,5.67 "; the text is moved behind it.
Place next_place(std::string_view& points) {
  const double x = next_number(points), y = next_number(points);
  return {std::lround(10 * x), std::lround(10 * y)};
}

// A number of tenths, as short as SVG allows: -3 is "-.3", and a minus parts two numbers as well as a space.
void append(std::string& path, long tenths) {
  const bool after_number = path.back() >= '0' && path.back() <= '9';
  if (tenths < 0)
    path += '-';
  else if (after_number)
    path += ' ';
  const long size = std::labs(tenths);
  if (size >= 10 || size == 0) path += std::to_string(size / 10);
  if (size % 10 != 0) path += '.' + std::to_string(size % 10);
}

void append_step(std::string& path, const Place& from, const Place& to) {
  append(path, to.x - from.x);
  append(path, to.y - from.y);
}

// Adds a polygon to a path: its first corner by the step from that of the polygon before, each other by the
// step that leads to it.
void append_polygon(std::string& path, Place& first, std::string_view points) {
  Place last = next_place(points);
  path += 'm';
  append_step(path, first, last);
  first = last;
  path += 'l';
  while (!points.empty()) {
    const Place next = next_place(points);
    append_step(path, last, next);
    last = next;
  }
  path += 'z';
}

// A path of all polygons of a plot; nothing if they are but a few.
std::string one_path(std::string_view polygons) {
  std::string path;
  std::size_t at = 0, count = 0;
  Place first{0, 0};
  const std::string colour(between(polygons, "fill = '", "'", at));
  for (std::string_view points; !(points = between(polygons, "points = '", "'", at)).empty(); ++count)
    append_polygon(path, first, points);
  return count < 4 ? "" : "<path fill='" + colour + "' stroke='" + colour + "' d='" + path + "'/>";
}

// A polygon, with all that is said of it, as a path. Its outline is told apart, if it has one.
std::string as_path(std::string_view polygon) {
  const std::string_view element = "<polygon", corners = "points = '";
  const std::size_t begin = polygon.find(corners), end = polygon.find('\'', begin + corners.size());
  std::string path;
  Place first{0, 0};
  append_polygon(path, first, polygon.substr(begin + corners.size(), end - begin - corners.size()));
  const std::size_t attributes = polygon.find(element) + element.size();
  return "<path stroke='none'" + std::string(polygon.substr(attributes, begin - attributes)) + "d='" + path +
         "'/>\n";
}

// gnuplot writes each polygon of a plot as an element of its own, and then all their outlines once more.
// Where there are many, as for a mesh, one path says the same in a fifth of the bytes.
std::string with_short_meshes(const std::string& svg) {
  const std::string open = "<g stroke='none'>\n\t\t<polygon", close = "</g>\n\t<path stroke='";
  std::string shorter;
  std::size_t done = 0;
  for (std::size_t begin; (begin = svg.find(open, done)) != std::string::npos;) {
    const std::size_t end = svg.find("</g>", begin);
    const std::size_t after = svg.find("/>", end);
    const bool outlined = end != std::string::npos && svg.compare(end, close.size(), close) == 0;
    const std::string path = outlined ? one_path(std::string_view(svg).substr(begin, end - begin)) : "";
    const std::size_t next = path.empty() ? begin + open.size() : after + 2;
    shorter += svg.substr(done, begin - done) + (path.empty() ? open : path);
    done = next;
  }
  return shorter + svg.substr(done);
}

// What a group can be replaced by, if it draws but one polygon, which has its own colour and needs no group,
// or nothing at all.
std::optional<std::string> bare(std::string_view content) {
  const std::size_t begin = content.find_first_not_of(" \t\n");
  if (begin == content.npos) return "";
  if (content.find("/>\n") + 3 != content.size()) return std::nullopt;
  if (content.find("<polygon") == begin) return as_path(content);
  if (content.find("<path stroke='none'") == 0) return std::string(content);
  return std::nullopt;
}

// Leaves out what can be left out of the groups from `open` to `close`.
std::string with_bare_groups(const std::string& svg, std::string_view open, std::string_view close) {
  std::string shorter;
  std::size_t done = 0;
  for (std::size_t begin; (begin = svg.find(open, done)) != std::string::npos;) {
    const std::size_t inside = svg.find(">\n", begin) + 2, end = svg.find(close, inside);
    if (end == std::string::npos) break;
    const auto content = bare(std::string_view(svg).substr(inside, end - inside));
    shorter += svg.substr(done, begin - done) + content.value_or(svg.substr(begin, inside - begin));
    done = content ? end + close.size() : inside;
  }
  return shorter + svg.substr(done);
}

std::string without_titles(const std::string& svg) {
  std::string shorter;
  std::size_t done = 0;
  for (std::size_t begin; (begin = svg.find("<title>gnuplot_plot_", done)) != std::string::npos;) {
    shorter += svg.substr(done, begin - done);
    done = svg.find("</title>", begin) + std::string_view("</title>").size();
  }
  return shorter + svg.substr(done);
}

}  // namespace

std::string short_svg(const std::string& svg) {
  std::string shorter = without_titles(with_short_meshes(svg));
  shorter = with_bare_groups(shorter, "\t<g stroke='none'>", "\t</g>\n");
  shorter = with_bare_groups(shorter, "<g fill=\"none\" color=\"", "</g>\n");
  return with_bare_groups(shorter, "\t<g id=\"gnuplot_plot_", "\t</g>\n");
}

}  // namespace first_contact::figure
