#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"
#include "first_contact/motion/chords.hpp"
#include "first_contact/motion/through_points.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using program::Program;
using program::Text;
namespace colour = first_contact::figure::colour;

namespace tween_bounce {

namespace {

constexpr View from_above{0, 0};

std::vector<Point> points_of(const Curve& curve, int steps) {
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i) points.push_back(at(curve, static_cast<double>(i) / steps));
  return points;
}

// What is drawn the same in each panel of de Casteljau's steps: three control points, some way to the right.
std::vector<Point> corners_at(Scene& scene, double right) {
  std::vector<Point> p{{right, 0, 0}, {right + 0.7, 2.2, 0}, {right + 3, 1.5, 0}};
  scene.line(p, {colour::grey, 1.2});
  const struct { double right, up; } aside[]{{-1.3, 0}, {-1, 0.7}, {1.4, 0.3}};
  for (std::size_t i = 0; i < p.size(); ++i) {
    scene.dot(p[i]);
    scene.label("{/:Italic P}_" + std::to_string(i), p[i], aside[i].right, aside[i].up);
  }
  return p;
}

// De Casteljau: between both pairs, between these, and so for every s.
void draw_de_casteljau(const Program& program) {
  const double s = 0.4, apart = 4.5;
  const auto mix = [](const Point& a, const Point& b, double part) -> Point {
    return (1 - part) * a + part * b;
  };
  Scene scene(from_above, 0.03);
  for (int panel = 0; panel < 3; ++panel) {
    const std::vector<Point> p = corners_at(scene, panel * apart);
    for (double t = 0.1; panel == 2 && t < 0.95; t += 0.1)
      scene.line({mix(p[0], p[1], t), mix(p[1], p[2], t)}, {colour::sky, 1});
    const Point a = mix(p[0], p[1], s), b = mix(p[1], p[2], s);
    if (panel == 1) scene.line({a, b}, {colour::blue, 2});
    if (panel == 2) scene.line(points_of(Bezier(p), 40), {colour::red, 2.6}, 2);
    if (panel < 2)
      for (const Point& q : {a, b}) scene.dot(q, colour::blue);
    if (panel > 0) scene.dot(mix(a, b, s), colour::red);
    const Text words[]{
        {"both sides", "兩邊各一點"}, {"between", "兩點之間"}, {"every {/:Italic s}", "每個 {/:Italic s}"}};
    scene.label(program.say(words[panel]), {panel * apart + 1.6, -0.75, 0});
  }
  scene.make_room({-0.6, -1, 0});
  scene.make_room({2 * apart + 3.5, 2.7, 0});
  Figure figure(program.studio(), "de-casteljau", scene.size(540));
  scene.draw(figure);
  figure.draw();
}

// The weight of control point i at all parameters: the height of a spline all of whose other points are at 0.
Table weight_rows(std::size_t i, const std::vector<double>& knots) {
  std::vector<Point> heights(7, Point::Zero());
  heights[i].y() = 1;
  const BSpline spline(heights, 3, knots);
  Table rows;
  for (int k = 0; k <= 80; ++k)
    rows.push_back({knots[3] + (knots[7] - knots[3]) * k / 80, spline.at(k / 80.0).y()});
  return rows;
}

// How much each control point counts: with clamped knots the first one alone at the beginning, the last one at the end.
void draw_knots(const Program& program) {
  const std::vector<double> clamped{0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4},
      loose{-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7};
  static constexpr const char* pens[]{"BLUE", "RED", "GREEN", "PINK", "ORANGE", "SKY", "INK"};
  Figure figure(program.studio(), "knots", {560, 260});
  std::ostream& out = figure.script();
  out << "unset key\nset xrange [-0.08:4.08]\nset yrange [-0.04:1.08]\nset xtics 1 font \",14\"\nset ytics "
         "0.5 font \",14\"\n"
      << "set border 3\nset tics nomirror\nset multiplot\nset bmargin at screen 0.32\nset tmargin at screen "
         "0.95\n";
  const auto panel = [&](const std::string& name, double left, const std::vector<double>& knots,
                         const Text& words) {
    std::string clauses;
    for (std::size_t i = 0; i < 7; ++i) {
      figure.data(name + std::to_string(i), weight_rows(i, knots), 5);
      clauses +=
          (i ? ", $" : "plot $") + name + std::to_string(i) + " with lines lc rgb " + pens[i] + " lw 2";
    }
    out << "set lmargin at screen " << left << "\nset rmargin at screen " << left + 0.4 << "\nset label 1 \""
        << program.say(words) << "\" at graph 0.5, -0.4 center tc rgb INK\n"
        << clauses << "\n";
  };
  panel("clamped", 0.1, clamped, {"clamped", "端點固定"});
  panel("loose", 0.585, loose, {"not clamped", "端點未固定"});
  out << "unset multiplot\n";
  figure.draw();
}

// Through the same keys: with knots that are evenly spaced, and with centripetal ones.
void draw_through(const Program& program) {
  const std::vector<Point> keys{{0, 0, 0}, {3.2, 1.9, 0}, {3.4, 1.6, 0}, {6, 0.2, 0}, {8.4, 1.5, 0}};
  Scene scene(from_above, 0.05);
  scene.line(points_of(catmull_rom(keys, Knots::uniform), 160), {colour::pink, 2.2}, 1);
  scene.line(points_of(catmull_rom(keys, Knots::centripetal), 160), {colour::green, 2.2}, 2);
  for (const Point& key : keys) scene.dot(key);
  scene.label(program.say({"evenly spaced knots", "結點等距"}), {3.75, 2, 0}, 0, 0, colour::pink,
              Align::left);
  scene.label(program.say({"centripetal", "向心"}), {4.9, 0.95, 0}, 0, 0, colour::green, Align::left);
  Figure figure(program.studio(), "through", scene.size(600));
  scene.draw(figure);
  figure.draw();
}

// The outline of all places that are nearer to a chord than a radius.
std::vector<Point> capsule(const Point& a, const Point& b, double radius) {
  const Vector along = (b - a).normalized(), across(-along.y(), along.x(), 0);
  std::vector<Point> outline;
  for (int i = 0; i <= 60; ++i) {
    const double angle = 2 * std::numbers::pi * i / 60;
    const bool at_b = i <= 30;
    outline.emplace_back((at_b ? b : a) + radius * (std::sin(angle) * along - std::cos(angle) * across));
    if (i == 30) outline.emplace_back(a + radius * across);
  }
  outline.push_back(outline.front());
  return outline;
}

// A ball on a curve, and the larger one on the chord that always holds it; and the same with the chord halved.
void draw_chord(const Program& program) {
  const double r = 0.5;
  Scene scene(from_above, 0.03);
  for (int panel = 0; panel < 2; ++panel) {
    const double right = panel * 6.6;
    const Bezier curve({{right, 0, 0}, {right + 2, 1.8, 0}, {right + 4.4, 0, 0}});
    scene.line(points_of(curve, 60), {colour::red, 2.2}, 2);
    for (int piece = 0; piece <= panel; ++piece) {
      const double from = piece / (panel + 1.0), to = (piece + 1) / (panel + 1.0);
      const Bezier part = curve.part(from, to);
      const double d = deviation_of_chord(part);
      scene.line({part.at(0), part.at(1)}, {colour::blue, 2}, 2);
      scene.line(capsule(part.at(0), part.at(1), r + d), {colour::grey, 1.4, true}, 1);
      scene.dot(part.at(0));
      scene.dot(part.at(1));
      if (panel == 1) continue;
      const Point ball = part.at(0.5), under = (part.at(0) + part.at(1)) / 2;
      scene.disc(ball, {0, 0, 1}, r, {colour::orange, 0.5, false, Pen{colour::ink, 1}}, 0);
      scene.line({ball, under}, {colour::ink, 1.2}, 3);
      scene.label("{/:Italic d}", under + 0.24 * (ball - under), 1.2, 0);  // below the ball
      scene.arrow(under, under - Vector(0, r + d, 0), {colour::ink, 1.4});
      scene.label("{/:Italic r} + {/:Italic d}", under - Vector(0, 0.6 * (r + d), 0), 2.6, 0);
    }
  }
  Figure figure(program.studio(), "chord", scene.size(600));
  scene.draw(figure);
  figure.draw();
}

}  // namespace

void draw_curve_lessons(const Program& program) {
  draw_de_casteljau(program);
  draw_knots(program);
  draw_through(program);
  draw_chord(program);
}

}  // namespace tween_bounce
