#include "parts.hpp"

#include <cmath>
#include <numbers>

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

Point at(double x, double y) { return {x, y, 0}; }

std::vector<Point> arc(const Point& center, double radius, double from, double to) {
  std::vector<Point> points;
  for (int i = 0; i <= 60; ++i) {
    const double angle = (from + (to - from) * i / 60) * std::numbers::pi / 180;
    points.emplace_back(center + radius * at(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void finish(const Studio& studio, const std::string& name, const figure::Scene& scene) {
  Figure figure(studio, name, scene.size());
  scene.draw(figure);
  figure.draw();
}
