#include "figures.hpp"
#include "parts.hpp"
#include "studies.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// Where a box pierces the plane z = 0: a convex polygon, in order around its middle.
std::vector<Point> waterline(const Box& box) {
  const auto corners = box.vertices();
  std::vector<Point> crossings;
  Point middle = Point::Zero();
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned axis = 1; axis < 8; axis *= 2) {
      const Point &p = corners[i], &q = corners[i ^ axis];
      if (i & axis || (p.z() > 0) == (q.z() > 0)) continue;
      crossings.emplace_back(p + p.z() / (p.z() - q.z()) * (q - p));
      middle += crossings.back();
    }
  middle /= static_cast<double>(crossings.size());
  std::sort(crossings.begin(), crossings.end(), [&](const Point& a, const Point& b) {
    return std::atan2(a.y() - middle.y(), a.x() - middle.x()) <
           std::atan2(b.y() - middle.y(), b.x() - middle.x());
  });
  return crossings;
}

}  // namespace

void draw_landings(const Studio& studio) {
  const Plane ground({0, 0, 1}, 0);
  const View view{66, 14};
  figure::Scene scene(view, 0.03);
  scene.patch({0, 0, 0}, {4.1, 0, 0}, {0, 1.5, 0}, plane_fill, -3);
  for (const auto& landing : box_chapter::landings()) {
    const ContactPoints& points = landing.contact.points;
    scene.polygon(shadow(landing.box, ground), {colour::shadow}, -2);
    scene.box(landing.box, glass);
    mark_contact(scene, points);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {  // each name outwards of its point, in the picture
      const Vector away = points.col(i) - landing.contact.point();
      const Eigen::Vector2d out = Eigen::Vector2d(away.dot(view.right()), away.dot(view.up())).normalized();
      const bool alone = points.cols() == 1;
      scene.label(name_of(points, i), points.col(i), alone ? 0.2 : 1.5 * out.x(),
                  alone ? -0.9 : 0.9 * out.y());
    }
  }
  Figure figure(studio, "landings", scene.size(900));
  scene.draw(figure);
  figure.draw();
}

void draw_signs(const program::Program& program) {
  const View view{76, 14};
  figure::Scene scene(view, 0.03);
  scene.patch({0, 0, 0}, {3.0, 0, 0}, {0, 1.5, 0}, plane_fill, -3);
  const Box upright = box_chapter::landings()[0].box;
  for (const bool printed : {true, false}) {
    const Vector half = 0.5 * (upright.r + upright.s + upright.t);
    const Point center(printed ? -1.5 : 1.5, 0, printed ? half.z() : upright.center.z());
    const Box box{center, upright.r, upright.s, upright.t};
    scene.polygon(shadow(box, Plane({0, 0, 1}, 0)), {colour::shadow}, -2);
    scene.box(box, glass);
    if (printed) {
      auto line = waterline(box);
      scene.polygon(line, {colour::pink, 0.45}, 2);
      line.push_back(line.front());
      scene.line(line, {colour::pink, 2.0}, 3);
      for (const double sign : {1.0, -1.0}) scene.dot(center + sign * half, colour::pink);
    } else {
      for (const Point& vertex : box.vertices()) scene.dot(vertex, colour::green);
    }
    scene.dot(center);
    scene.label("{/:Italic Q}", center, 0.9, 0.5);
    const program::Text said = printed ? program::Text{"one common sign", "同一符號"}
                                       : program::Text{"three signs of their own", "三個獨立符號"};
    const Point below = center.x() * Vector::UnitX();
    scene.label(program.say(said), below - (1.5 + below.dot(view.up())) * view.up(), 0, 0,
                printed ? colour::pink : colour::green);
  }
  Figure figure(program.studio(), "signs", scene.size(900));
  scene.draw(figure);
  figure.draw();
}
