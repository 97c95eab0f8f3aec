#include "first_contact/figure/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "first_contact/figure/paint.hpp"

namespace first_contact::figure {

namespace {

constexpr std::size_t many_triangles = 200;
constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

std::vector<Point> ring(const Point& center, const Vector& normal, double radius) {
  const Vector u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
  std::vector<Point> points;
  points.reserve(64);
  for (int i = 0; i < 64; ++i)
    points.emplace_back(center + radius * (std::cos(2 * pi * i / 64) * u + std::sin(2 * pi * i / 64) * v));
  return points;
}

}  // namespace

Vector View::eye() const {
  return {std::sin(tilt * degree) * std::sin(turn * degree),
          -std::sin(tilt * degree) * std::cos(turn * degree), std::cos(tilt * degree)};
}
Vector View::right() const { return {std::cos(turn * degree), std::sin(turn * degree), 0}; }
Vector View::up() const { return eye().cross(right()); }

// Seen from straight above, up in the picture is y, and there the light must come from.
Scene::Scene(View view, double margin, const Point& origin)
    : eye_(view.eye()),
      right_(view.right()),
      up_(view.up()),
      light_((view.tilt == 0 ? Vector(-0.45, 0.75, 0.9) : Vector(-0.35, -0.75, 0.9)).normalized()),
      margin_(margin),
      origin_(origin) {}

void Scene::add(const std::vector<Point>& points, std::string style, int layer, std::optional<double> depth) {
  Item item{layer, 0, std::move(style), {}};
  Point middle = Point::Zero();
  for (const Point& p : points) {
    middle += p / static_cast<double>(points.size());
    item.points.push_back(project(p));
  }
  item.depth = depth.value_or(middle.dot(eye_));
  items_.push_back(std::move(item));
}

std::string Scene::fill_style(const Fill& fill, const Vector& normal) const {
  if (!fill.shaded) return area(flat(fill.colour, fill.opacity), false);
  const Vector facing = normal.dot(eye_) < 0 ? Vector(-normal) : normal;
  return area(shade(lit(fill.colour.light, facing.dot(light_)), fill.opacity), fill.opacity >= 1);
}

void Scene::polygon(const std::vector<Point>& corners, const Fill& fill, int layer) {
  if (corners.size() < 3) return;
  const Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  add(corners, fill_style(fill, normal), layer);
  if (!fill.outline) return;
  std::vector<Point> closed = corners;
  closed.push_back(corners.front());
  add(closed, "lines " + stroke(*fill.outline), layer, items_.back().depth);
}

void Scene::patch(const Point& center, const Vector& u, const Vector& v, const Fill& fill, int layer) {
  polygon({center - u - v, center + u - v, center + u + v, center - u + v}, fill, layer);
}

void Scene::disc(const Point& center, const Vector& normal, double radius, const Fill& fill, int layer) {
  polygon(ring(center, normal, radius), fill, layer);
}

void Scene::line(const std::vector<Point>& points, const Pen& pen, int layer) {
  add(points, "lines " + stroke(pen), layer);
}

void Scene::arrow(const Point& from, const Point& to, const Pen& pen, int layer) {
  add({from, to}, "vectors filled head size screen 0.022,18,60 " + stroke(pen), layer);
}

// The visible part of the cap of all directions within `angle` of the pole, which is itself visible: outwards
// along each meridian as far as the cap's rim, or the ball's outline, whichever comes first.
void Scene::cap(const Sphere& ball, const Vector& pole, double angle, const std::string& style, int layer) {
  const Vector u = pole.unitOrthogonal(), v = pole.cross(u);
  std::vector<Point> rim;
  for (int i = 0; i < 72; ++i) {
    const Vector along = std::cos(2 * pi * i / 72) * u + std::sin(2 * pi * i / 72) * v;
    const double outline = std::atan2(pole.dot(eye_), -along.dot(eye_));
    const double a = std::min(angle, outline);
    rim.emplace_back(ball.center + ball.radius * (std::cos(a) * pole + std::sin(a) * along));
  }
  add(rim, style, layer, ball.center.dot(eye_));
}

void Scene::sphere(const Sphere& ball, const Colour& colour, double opacity, int layer, double step) {
  const std::vector<Point> outline = ring(ball.center, eye_, ball.radius);
  const double depth = ball.center.dot(eye_);
  if (opacity < 1) {  // glass: one even fill, a few faint lights upon it, and a rim
    add(outline, area(flat(colour, opacity), false), layer, depth);
    for (int angle = 64; angle > 0; angle -= 4)
      cap(ball, light_, angle * degree, area(shade(light_colour, 0.035), false), layer);
    std::vector<Point> closed = outline;
    closed.push_back(outline.front());
    add(closed, "lines " + stroke({colour, 1.2}), layer, depth);
    return;
  }
  add(outline, area(shade(lit(colour.light, 0), 1), false), layer, depth);
  for (int i = 0; i * step < 90; ++i) {
    const double angle = 90 - i * step;
    const double cosine = std::cos((angle - step / 2) * degree);
    cap(ball, light_, angle * degree, area(shade(lit(colour.light, cosine), 1), false), layer);
  }
}

void Scene::box(const Box& box, const Fill& fill, int layer) {
  const auto corners = box.vertices();
  const std::array<Vector, 3> axes{box.r, box.s, box.t};
  const auto hidden = [&](unsigned axis, bool positive) {
    return (positive ? 1 : -1) * axes[axis].dot(eye_) <= 0;
  };
  for (unsigned axis = 0; axis < 3; ++axis)
    for (const bool positive : {false, true}) {
      const unsigned base = positive ? 1U << axis : 0, u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3;
      if (!hidden(axis, positive))
        polygon({corners[base], corners[base + u], corners[base + u + v], corners[base + v]}, fill, layer);
    }
  const double near = box.center.dot(eye_) + box.effective_radius(eye_);
  constexpr double far = -std::numeric_limits<double>::max();
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned side = 0; side < 4; ++side) {
      const unsigned b = (axis + 1) % 3, c = (axis + 2) % 3;
      const unsigned start = ((side & 1U) ? 1U << b : 0) + ((side & 2U) ? 1U << c : 0);
      const std::vector<Point> ends{corners[start], corners[start + (1U << axis)]};
      const bool behind = hidden(b, side & 1U) && hidden(c, side & 2U);
      if (!behind) add(ends, "lines " + stroke({colour::ink, 1.4}), layer, near);
      if (behind && fill.opacity < 1) add(ends, "lines " + stroke({colour::grey, 1.0, true}), layer, far);
    }
}

void Scene::mesh(const Mesh& mesh, const Fill& fill, bool closed, int layer) {
  if (mesh.size() > many_triangles && fill.shaded && !fill.outline)
    return fine_mesh(mesh, fill, closed, layer);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Triangle triangle = mesh.triangle(i);
    if (closed && triangle.area_vector().dot(eye_) <= 0) continue;
    polygon({triangle.a, triangle.b, triangle.c}, fill, layer);
  }
}

// Of many small triangles, those in a thin slab of depth hardly ever hide each other, and a few shades do:
// sorted by slab and shade, most neighbours are drawn alike and share a clause, so that the picture stays
// small.
void Scene::fine_mesh(const Mesh& mesh, const Fill& fill, bool closed, int layer) {
  constexpr double shades = 16, slabs = 12;
  Eigen::AlignedBox<double, 1> depths;
  for (const Point& vertex : mesh.vertices()) depths.extend(Eigen::Matrix<double, 1, 1>(vertex.dot(eye_)));
  const double thickness = std::max(depths.sizes()[0] / slabs, std::numeric_limits<double>::min());

  std::map<std::pair<double, double>, std::vector<std::size_t>> alike;  // by depth of the slab and shade
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Triangle triangle = mesh.triangle(i);
    const Vector area = triangle.area_vector();
    if (area.isZero(0) || (closed && area.dot(eye_) <= 0)) continue;
    const double cosine = (area.dot(eye_) < 0 ? -1 : 1) * area.dot(light_) / area.norm();
    const double depth = (triangle.a + triangle.b + triangle.c).dot(eye_) / 3;
    alike[{thickness * std::round(depth / thickness), std::round(shades * std::max(0.0, cosine)) / shades}]
        .push_back(i);
  }
  for (const auto& [key, triangles] : alike) {
    const std::string style =
        area(shade(lit(fill.colour.light, key.second), fill.opacity), fill.opacity >= 1);
    for (const std::size_t i : triangles) {
      const Triangle triangle = mesh.triangle(i);
      add({triangle.a, triangle.b, triangle.c}, style, layer, key.first);
    }
  }
}

void Scene::dot(const Point& at, const Colour& colour) {
  add({at}, "points pt 7 ps 0.5 lc rgb " + std::string(colour.name), 9);
}

void Scene::label(const std::string& text, const Point& at, double right, double up, const Colour& colour,
                  Align align) {
  texts_.push_back({text, project(at), right, up, colour, align});
}

Eigen::AlignedBox2d Scene::extent() const {
  Eigen::AlignedBox2d all = room_;
  for (const Item& item : items_)
    for (const auto& p : item.points) all.extend(p);
  for (const Text& text : texts_) all.extend(text.at);
  const Eigen::Vector2d space = Eigen::Vector2d::Constant(margin_ * all.sizes().maxCoeff());
  return {all.min() - space, all.max() + space};
}

Size Scene::size(int width) const {
  const Eigen::Vector2d sides = extent().sizes();
  const double height = width * sides.y() / sides.x();
  return {width, static_cast<int>(std::clamp(height, 0.3 * width, 1.2 * width))};
}

void Scene::write_frame(std::ostream& out) const {
  const Eigen::AlignedBox2d frame = extent();
  out << "unset border; unset tics; unset key; set size ratio -1\n"
      << "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
      << "set xrange [" << frame.min().x() << ":" << frame.max().x() << "]\n"
      << "set yrange [" << frame.min().y() << ":" << frame.max().y() << "]\n";
}

void Scene::write_texts(std::ostream& out) const {
  for (const Text& text : texts_)
    out << "set label \"" << text.text << "\" at " << text.at.x() << "," << text.at.y() << " "
        << (text.align == Align::left    ? "left"
            : text.align == Align::right ? "right"
                                         : "center")
        << " offset character " << text.right << "," << text.up << " front tc rgb " << text.colour.name
        << "\n";
}

std::vector<const Scene::Item*> Scene::far_to_near() const {
  std::vector<const Item*> order;
  for (const Item& item : items_) order.push_back(&item);
  std::stable_sort(order.begin(), order.end(), [](const Item* a, const Item* b) {
    return std::pair(a->layer, a->depth) < std::pair(b->layer, b->depth);
  });
  return order;
}

void Scene::add_rows(Table& rows, const Item& item) {
  if (!rows.empty()) rows.emplace_back();
  if (!item.style.starts_with("vectors")) {
    for (const auto& p : item.points) rows.push_back({p.x(), p.y()});
    return;
  }
  const Eigen::Vector2d &from = item.points[0], along = item.points[1] - from;
  rows.push_back({from.x(), from.y(), along.x(), along.y()});
}

std::string Scene::write(Figure& figure) const {
  write_frame(figure.script());
  write_texts(figure.script());
  const std::vector<const Item*> order = far_to_near();
  std::string clauses;
  int block = 0;
  for (std::size_t i = 0; i < order.size();) {  // neighbours that are drawn alike share one clause
    const std::string& style = order[i]->style;
    Table rows;
    for (; i < order.size() && order[i]->style == style; ++i) add_rows(rows, *order[i]);
    const std::string name = "s" + std::to_string(block++);
    figure.data(name, rows, 5);
    clauses += clauses.empty() ? "$" : ", \\\n $";
    clauses.append(name).append(" with ").append(style).append(" notitle");
  }
  return clauses;
}

void Scene::draw(Figure& figure) const {
  const std::string clauses = write(figure);
  figure.script() << "plot " << clauses << "\n";
}

}  // namespace first_contact::figure
