#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/soup.hpp"
#include "grown_planes.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

constexpr double pi = std::numbers::pi;

// Seen along the y axis: x to the right, z up.
const View front{90, 0};

std::vector<Point> arc(const Point& center, double radius, double from, double to) {
  std::vector<Point> points;
  for (int i = 0; i <= 48; ++i) {
    const double angle = from + (to - from) * i / 48;
    points.emplace_back(center + radius * Vector(std::cos(angle), 0, std::sin(angle)));
  }
  return points;
}

void add_ball(figure::Scene& scene, const Point& center, double radius, double opacity, int layer = 3) {
  scene.polygon(arc(center, radius, 0, 2 * pi), {colour::amber, opacity, false, Pen{colour::orange, 1.2}},
                layer);
}

void add_motion(figure::Scene& scene, const Point& from, const Point& to, double radius,
                const Colour& colour) {
  add_ball(scene, from, radius, 1);
  add_ball(scene, to, radius, 0.4);
  scene.arrow(from, to, {colour, 2.4}, 4);
  scene.dot(from);
  scene.dot(to);
}

// How high above the edge the grown planes stop the ball.
void measure_height(figure::Scene& scene, double early) {
  const double x = -2.2;
  scene.line({{0, 0, 0}, {x - 0.1, 0, 0}}, {colour::grey, 1.0, true}, -1);
  scene.line({{0, 0, early}, {x - 0.1, 0, early}}, {colour::grey, 1.0, true}, -1);
  scene.arrow({x, 0, 0.5 * early}, {x, 0, early}, {colour::pink, 2.0});
  scene.arrow({x, 0, 0.5 * early}, {x, 0, 0}, {colour::pink, 2.0});
  scene.label("{/:Italic r} / sin {/:Italic α}", {x, 0, 0.5 * early}, -0.6, 0, colour::pink, Align::right);
}

}  // namespace

void draw_same_side(const Studio& studio) {
  const double r = 0.5;
  figure::Scene scene(front, 0.04);
  const auto level = [&](double z, const Pen& pen, const char* name, const Colour& colour) {
    scene.line({{-4.4, 0, z}, {4.4, 0, z}}, pen, 1);
    scene.label(name, {4.5, 0, z}, 0, 0, colour, Align::left);
  };
  scene.polygon({{-4.4, 0, -r}, {4.4, 0, -r}, {4.4, 0, r}, {-4.4, 0, r}}, {colour::mist}, 0);
  level(r, {colour::grey, 1.2, true}, "{/:Italic E}·{/:Italic Q} = {/:Italic r}", colour::grey);
  level(0, {colour::blue, 2.4}, "{/:Italic E}·{/:Italic Q} = 0", colour::blue);
  level(-r, {colour::grey, 1.2, true}, "{/:Italic E}·{/:Italic Q} = −{/:Italic r}", colour::grey);
  add_motion(scene, {-3.5, 0, 1.9}, {-1.5, 0, 0.85}, r, colour::green);
  add_motion(scene, {0.1, 0, -0.9}, {-2.2, 0, -1.7}, r, colour::green);
  add_motion(scene, {1.5, 0, 1.6}, {3.4, 0, -0.9}, r, colour::red);
  scene.arrow({-4.1, 0, 0}, {-4.1, 0, 0.9}, {colour::ink, 2.4});
  scene.label("{/:Bold N}", {-4.1, 0, 0.9}, 1.2, 0);
  const double out = 1.5 * r;
  scene.label("{/:Italic Q}_1", Point(-3.5, 0, 1.9) + Vector(-out, 0, 0));
  scene.label("{/:Italic Q}_2", Point(-1.5, 0, 0.85) + Vector(out, 0, 0.1));
  scene.label("{/:Italic Q}_1", Point(0.1, 0, -0.9) + Vector(out, 0, 0));
  scene.label("{/:Italic Q}_2", Point(-2.2, 0, -1.7) + Vector(-out, 0, 0));
  scene.label("{/:Italic Q}_1", Point(1.5, 0, 1.6) + Vector(out, 0, 0.1));
  scene.label("{/:Italic Q}_2", Point(3.4, 0, -0.9) + Vector(out, 0, -0.1));
  scene.dot({5.9, 0, 0}, colour::paper);
  Figure figure(studio, "same-side", scene.size());
  scene.draw(figure);
  figure.draw();
}

void draw_grown_planes(const Studio& studio) {
  const double r = 1, half = 15 * pi / 180, depth = 3.4;
  const Wedge wedge{half};
  const Point edge(0, 0, 0), corner(0, 0, r / std::sin(half));
  const Vector right(std::sin(half), 0, -std::cos(half)), left(-right.x(), 0, right.z());
  const Vector out_right(std::cos(half), 0, std::sin(half)), out_left(-out_right.x(), 0, out_right.z());
  const double long_side = (corner.z() + depth) / std::cos(half), side = depth / std::cos(half);
  figure::Scene scene(front, 0.03);
  scene.polygon({corner, corner + long_side * right, corner + long_side * left}, {colour::pink, 0.16}, -2);
  scene.polygon({edge, edge + side * right, edge + side * left},
                {colour::floor, 1, false, Pen{colour::blue, 1.6}}, 0);
  scene.line({corner + long_side * left, corner, corner + long_side * right}, {colour::pink, 2.2, true}, 1);
  // The true surface of all centres in contact: r from the faces, and an arc about the edge.
  const double straight = (depth + r * std::sin(half)) / std::cos(half);
  std::vector<Point> surface{edge + r * out_right + straight * right};
  for (const Point& p : arc(edge, r, half, pi - half)) surface.push_back(p);
  surface.emplace_back(edge + r * out_left + straight * left);
  scene.line(surface, {colour::green, 2.6}, 4);
  const Moving<Sphere> falling{{{0, 0, 16}, r}, {0, 0, -16}};
  const double early = 16 - 16 * *time_at_grown_planes(falling, wedge);
  const double touching = 16 - 16 * sweep(falling, Soup<BspTree>(wedge.faces()))->time;
  add_ball(scene, {0, 0, early}, r, 0.35);
  add_ball(scene, {0, 0, touching}, r, 0.5, 3);
  scene.dot({0, 0, early}, colour::pink);
  scene.dot({0, 0, touching}, colour::green);
  scene.dot(edge);
  measure_height(scene, early);
  scene.arrow({0, 0, touching}, Point(r * std::cos(0.9), 0, touching + r * std::sin(0.9)),
              {colour::green, 2.0}, 5);
  scene.label("{/:Italic r}", Point(0.5 * r * std::cos(0.9), 0, touching + 0.5 * r * std::sin(0.9)), 0.9,
              -0.2, colour::green);
  scene.line(arc(edge, 1.5, -pi / 2, -pi / 2 + half), {colour::ink, 1.2}, 3);
  scene.line({edge, {0, 0, -1.9}}, {colour::grey, 1.0, true}, 3);
  scene.label("{/:Italic α}", {0.24, 0, -1.75}, 0.2, -0.2);
  Figure figure(studio, "grown-planes", scene.size(540));
  scene.draw(figure);
  figure.draw();
}
