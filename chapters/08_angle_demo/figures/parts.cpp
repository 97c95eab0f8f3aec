#include "parts.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;
using Eigen::Vector2d;

Point flat(const Vector2d& v) { return {v.x(), v.y(), 0}; }

std::string number_text(double value, const char* form) {
  char text[40];
  std::snprintf(text, sizeof text, form, std::abs(value));
  return (value < 0 ? "−" : "") + std::string(text);
}

std::string angle_text(double degrees) { return number_text(degrees, "%.4g°"); }

void add_disc(figure::Scene& scene, const Vector2d& center, double radius, const Colour& colour,
              double opacity) {
  std::vector<Point> rim;
  for (int i = 0; i < 120; ++i) {
    const double angle = i * std::numbers::pi / 60;
    rim.push_back(flat(center + radius * Vector2d(std::cos(angle), std::sin(angle))));
  }
  scene.polygon(rim, {colour, opacity, false, Pen{colour, 1.4}}, 0);
}

void add_velocity(figure::Scene& scene, const Vector2d& center, double rim, const Vector2d& velocity,
                  const Colour& colour, const Name& name) {
  if (velocity.norm() == 0) return;
  const Vector2d way = velocity.normalized(), tip = center + rim * way + velocity;
  scene.arrow(flat(center + rim * way), flat(tip), {colour, 2.4}, 3);
  if (name.text.empty()) return;
  const bool level = std::abs(way.x()) > 0.6;
  const Align align = !level ? name.side : way.x() > 0 ? Align::left : Align::right;
  const double aside = align == Align::left ? 0.6 : align == Align::right ? -0.6 : 0;
  scene.label(name.text, flat(tip), aside, level ? 0.6 * way.y() : 0.9 * way.y(), colour, align);
  scene.label("",
              flat(tip + (level ? name.room * Vector2d(way.x() > 0 ? 1 : -1, 0) : 0.3 * name.room * way)));
  if (!level && align == Align::centre) scene.label("", flat(tip - Vector2d(0.6 * name.room, 0)));
}
